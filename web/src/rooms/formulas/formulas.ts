// Room 2: the period against the amplitude, exact and by every published formula, and the errors of the formulas.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import { Mathematics } from "../../engine/mathematics.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { Form } from "../../parts/form.ts";
import { inWords } from "../../parts/in_words.ts";
import { Latest } from "../../parts/latest.ts";
import { angle, angleEntry, digits } from "../../parts/numbers.ts";
import { saveAnswer } from "../../parts/save.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import type { Catalogue, Formula, Periods } from "./catalogue.ts";
import { curves, curvesCommand, exactRatio, type Span } from "./curves.ts";
import { ErrorPicture } from "./error_picture.ts";
import { fields } from "./fields.ts";
import { looks } from "./looks.ts";
import { PeriodPicture } from "./period_picture.ts";
import { card, curveTable, readout } from "./results.ts";
import { Searches } from "./searches.ts";
import { Selection } from "./selection.ts";

const words = text.formulas;
const DEGREE = Math.PI / 180;
/** Largest amplitude that can be chosen, in degrees: at the top itself there is no period. */
const LARGEST = 179.9;

export const formulas: Room = {
  name: "formulas",
  open(place, address, engine) {
    const room = new FormulasRoom(address, engine);
    place.append(...room.elements);
    room.begin();
    return () => room.leave();
  },
};

class FormulasRoom {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #said: (sentence: string) => string;
  readonly #selection: Selection;
  readonly #period: PeriodPicture;
  readonly #errors: ErrorPicture;
  readonly #searches: Searches;
  readonly #latest = new Latest();
  readonly #pointing = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #equivalents = new Equivalents();
  readonly #failure = element("p", { class: "error", role: "alert", hidden: true });
  readonly #verdict = element("p", { "aria-live": "polite" });
  readonly #readout = element("div");
  readonly #tables = { period: element("div"), errors: element("div") };
  readonly #cards = element("section");
  #mathematics: Mathematics | undefined;
  #catalogue: ReadonlyMap<string, Formula> = new Map();
  /** The values at the chosen amplitude. */
  #values: Periods["results"][number] | undefined;
  #curved = "";
  #drawn = "";
  #tolerated = "";

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    const all = fields();
    this.#said = inWords(all);
    this.#form = new Form(address, all, () => this.#update());
    this.#selection = new Selection(address, () => this.#update());
    const nearest = (amplitude: number) => Math.min(Math.max(Math.round(amplitude * 10) / 10, 0.1), LARGEST);
    const [moved, under] = [(amplitude: number) => this.#move(amplitude), (amplitude: number | undefined) => this.#point(amplitude)];
    this.#period = new PeriodPicture(nearest, moved, under);
    this.#errors = new ErrorPicture(engine, nearest, moved, under);
    this.#searches = new Searches(address, engine, this.#form, () => this.#update());
    this.elements = [element("h1", {}, words.title), element("p", { class: "lead" }, words.lead), element("div", { class: "room" }, this.#controls(), this.#results())];
  }

  #controls(): HTMLElement {
    const question = this.#form.part(words.question, ["amplitude", "tolerance", "unit"]);
    const axes = this.#form.part(words.axes, ["from", "to", "lowest"], { folded: true });
    return element("div", { class: "controls" }, question, this.#selection.element, axes);
  }

  #results(): HTMLElement {
    const csv = button(text.parts.saveData, () => void this.#saveValues());
    const asTable = (title: string, place: HTMLElement) => element("details", { class: "asked" }, element("summary", {}, title), place);
    return element(
      "div",
      { class: "results" },
      this.#status.element, this.#failure,
      element("div", { class: "comparison" }, this.#period.element, element("div", {}, this.#readout, element("p", { class: "buttons" }, csv))),
      this.#verdict, element("p", { class: "hint screen-only" }, words.pictureHint),
      asTable(words.period.asTable, this.#tables.period),
      element("h2", {}, words.errors.title), element("p", { class: "quiet" }, words.errors.look), this.#errors.picture.element,
      asTable(words.errors.asTable, this.#tables.errors),
      ...this.#searches.elements, this.#cards, this.#equivalents.element,
    );
  }

  // The exact curve needs the small module only, and is drawn before the large one is ready.
  begin(): void {
    const drawn = async () => {
      this.#mathematics = await Mathematics.load();
      this.#spread();
      this.#period.begin(this.#mathematics);
      const read = this.#mathematics.angle(this.#amplitude());
      if ("radians" in read && read.radians > 0) this.#mark(read.radians / DEGREE);
    };
    const offered = async (signal: AbortSignal) => {
      await drawn();
      const { value } = await read<Catalogue>(this.#engine, { question: "formulas" }, signal);
      this.#catalogue = new Map(value?.formulas.map((formula) => [formula.key, formula]));
      this.#selection.offer(value?.formulas ?? []);
      await this.#answer(signal);
    };
    this.#latest.run((signal) => this.#status.during(offered(signal)));
  }

  leave(): void {
    this.#latest.stop();
    this.#pointing.stop();
    this.#period.close();
  }

  #update(): void {
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  // Runs the queries one after the other; each failure is shown next to its field, and the previous results stay.
  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    this.#fail("");
    const keys = this.#selection.keys;
    if (keys.length === 0) return this.#fail(words.noneChosen);
    this.#equivalents.show([this.#at(keys), curvesCommand(keys, this.#spread()), ...this.#searches.commands(keys), this.#errors.picture.command(this.#figure(keys))]);
    for (const step of [this.#judge, this.#curve, this.#draw, this.#tolerate]) {
      if (!signal.aborted) await step.call(this, keys, signal);
    }
    if (!signal.aborted) await this.#searches.range(keys, this.#values, signal);
    if (!signal.aborted) await this.#searches.cross(keys, this.#catalogue, signal);
  }

  #amplitude(): string {
    return this.#form.value("amplitude");
  }

  #unit(): string {
    return this.#form.value("unit");
  }

  #chosen(keys: readonly string[]): Formula[] {
    return keys.flatMap((key) => this.#catalogue.get(key) ?? []);
  }

  #at(keys: readonly string[], amplitude = this.#amplitude()): Command {
    return { question: "period", arguments: [amplitude], options: given({ formulas: keys.join(",") }) };
  }

  #figure(keys: readonly string[]): Command {
    const [from, to] = [this.#form.chosen("from"), this.#form.chosen("to")];
    return this.#errors.command(keys, { from, to, lowest: Number(this.#form.value("lowest")) });
  }

  /** Sets the amplitudes at the ends of the first picture to the entered ones, if they are valid. */
  #spread(): Span {
    const [from = NaN, to = NaN] = ["from", "to"].map((key) => {
      const read = this.#mathematics?.angle(this.#form.value(key));
      return read !== undefined && "radians" in read ? Number((read.radians / DEGREE).toPrecision(12)) : NaN;
    });
    const span = from >= 0 && from < to && to <= 180 ? { from, to } : { from: 0, to: 180 };
    this.#period.spread(span);
    return span;
  }

  async #judge(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const amplitude = this.#amplitude();
    const { answer, value } = await read<Periods>(this.#engine, this.#at(keys), signal);
    const period = value?.results[0];
    // The reader may have moved on, and a newer query follows.
    if (signal.aborted || amplitude !== this.#amplitude()) return;
    if (answer.status !== 0 || period === undefined) return this.#fail(this.#form.blame(answer));
    this.#values = period;
    this.#verdict.textContent = words.exact(angle(period.amplitude_rad, this.#unit()), digits(period.ratio, 12));
    this.#mark(period.amplitude_rad / DEGREE);
    this.#show(period, keys);
    this.#cards.replaceChildren(element("h2", {}, words.cards), ...this.#chosen(keys).map(card));
  }

  #show(period: Periods["results"][number], keys: readonly string[]): void {
    this.#readout.replaceChildren(readout(period, this.#chosen(keys), Number(this.#form.value("tolerance")), this.#unit(), (key) => this.#open(key)));
  }

  #open(key: string): void {
    const opened = this.#cards.querySelector<HTMLElement>(`#formula-${key}`);
    opened?.scrollIntoView({ block: "center" });
    opened?.focus();
  }

  async #curve(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const [span, unit] = [this.#spread(), this.#unit()];
    const asked = JSON.stringify([keys, span, unit]);
    if (asked === this.#curved) return;
    const found = await curves(this.#engine, keys, span, signal);
    if (found === undefined || signal.aborted || this.#mathematics === undefined) return;
    this.#curved = asked;
    this.#period.show(found.degrees, found.all, looks(keys.map((key) => this.#catalogue.get(key)?.family ?? key)));
    const mathematics = this.#mathematics;
    const exact = found.degrees.map((degrees) => exactRatio(mathematics, degrees));
    const name = (key: string) => this.#catalogue.get(key)?.name ?? key;
    const [ratios, errors] = (["ratios", "errors"] as const).map((which) => found.all.map((curve) => ({ name: name(curve.key), values: curve[which] })));
    this.#tables.period.replaceChildren(curveTable(words.period.title, found.degrees, [{ name: words.exactName, values: exact }, ...(ratios ?? [])], unit));
    this.#tables.errors.replaceChildren(curveTable(words.errors.title, found.degrees, errors ?? [], unit));
  }

  async #draw(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const command = this.#figure(keys);
    if (JSON.stringify(command) === this.#drawn) return;
    const answer = await this.#errors.picture.draw(command, signal);
    if (signal.aborted) return;
    this.#drawn = JSON.stringify(command);
    this.#errors.lines();
    if (answer.status !== 0) this.#fail(this.#form.blame(answer));
  }

  // The tolerance is checked by the fastest query that reads it.
  async #tolerate(_: readonly string[], signal: AbortSignal): Promise<void> {
    const tolerance = this.#form.value("tolerance");
    if (tolerance === this.#tolerated) return;
    const answer = await ask(this.#engine, this.#searches.holding(["small_angle"]), { signal });
    if (signal.aborted) return;
    if (answer.status === 0) this.#tolerated = tolerance;
    else this.#fail(this.#form.blame(answer));
  }

  /** Marks the amplitude, in degrees, in both pictures. */
  #mark(degrees: number): void {
    const said = this.#mathematics === undefined ? "" : words.said(angle(degrees * DEGREE, this.#unit()), digits(exactRatio(this.#mathematics, degrees), 5));
    this.#period.mark(degrees, said);
    this.#errors.mark(degrees, Number(this.#form.value("tolerance")), said);
  }

  #move(degrees: number): void {
    this.#form.put("amplitude", angleEntry(degrees));
    this.#mark(degrees);
    this.#update();
  }

  // The readout has the values under the pointer until it leaves the picture.
  #point(degrees: number | undefined): void {
    this.#pointing.run(async (signal) => {
      const keys = this.#selection.keys;
      if (keys.length === 0) return;
      if (degrees === undefined) return this.#values === undefined ? undefined : this.#show(this.#values, keys);
      const { value } = await read<Periods>(this.#engine, this.#at(keys, angleEntry(degrees)), signal);
      const [period] = value?.results ?? [];
      if (period !== undefined && !signal.aborted) this.#show(period, keys);
    });
  }

  async #saveValues(): Promise<void> {
    const keys = this.#selection.keys;
    if (keys.length === 0) return this.#fail(words.noneChosen);
    const answer = await ask(this.#engine, extended(this.#at(keys), { csv: true }));
    const failure = saveAnswer("formulas.csv", answer, "text/csv");
    if (failure !== "") this.#fail(this.#form.blame(answer));
  }

  #fail(reason: string): void {
    this.#failure.textContent = this.#said(reason);
    this.#failure.hidden = reason === "";
  }
}
