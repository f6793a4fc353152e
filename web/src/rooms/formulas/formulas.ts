// Room 2: every formula for the period compared with the exact one.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { choiceField, textField } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { Latest } from "../../parts/latest.ts";
import { angle, angleEntry, digits } from "../../parts/numbers.ts";
import { saveAnswer } from "../../parts/save.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import { unitSwitch } from "../../parts/unit_switch.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import type { Catalogue, Crossovers, Formula, Periods } from "./catalogue.ts";
import { ErrorPicture } from "./error_picture.ts";
import { card, crossovers, limit, values } from "./results.ts";
import { Selection } from "./selection.ts";

const words = text.formulas;
const DEGREE = Math.PI / 180;
const LOWEST = ["1e-3", "1e-5", "1e-8", "1e-12", "1e-16", "1e-30"];

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
  readonly #selection: Selection;
  readonly #picture: ErrorPicture;
  readonly #latest = new Latest();
  readonly #pointing = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #equivalents = new Equivalents();
  readonly #failure = element("p", { class: "error", role: "alert", hidden: true });
  readonly #under = element("p", { class: "quiet under screen-only" }, words.pictureHint);
  readonly #verdict = element("div", { "aria-live": "polite" });
  readonly #values = element("div");
  readonly #crossovers = element("section");
  readonly #cards = element("section");
  #catalogue: ReadonlyMap<string, Formula> = new Map();
  #drawn = "";
  #crossed = "";

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    this.#form = new Form(address, fields(), () => this.#update());
    this.#selection = new Selection(address, () => this.#update());
    this.#picture = new ErrorPicture(engine, (amplitude) => this.#move(amplitude), (amplitude) => this.#point(amplitude));
    const question = this.#form.part(words.question, ["amplitude", "tolerance", "unit"], { open: true });
    const axes = this.#form.part(words.axes, ["from", "to", "lowest"], { folded: true });
    const controls = element("div", { class: "controls" }, question, this.#selection.element, axes);
    const csv = button(text.parts.saveData, () => void this.#saveValues());
    const results = element(
      "div",
      { class: "results" },
      this.#status.element, this.#failure, this.#verdict, this.#picture.picture.element, this.#under,
      this.#values, element("p", { class: "buttons" }, csv), this.#crossovers, this.#cards, this.#equivalents.element,
    );
    this.elements = [element("h1", {}, words.title), element("p", { class: "lead" }, words.lead), element("div", { class: "room" }, controls, results)];
  }

  begin(): void {
    const offered = async (signal: AbortSignal) => {
      const { value } = await read<Catalogue>(this.#engine, { question: "formulas" }, signal);
      this.#selection.offer(value?.formulas ?? []);
      await this.#answer(signal);
    };
    this.#latest.run((signal) => this.#status.during(offered(signal)));
  }

  leave(): void {
    this.#latest.stop();
    this.#pointing.stop();
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
    this.#equivalents.show(this.#commands(keys));
    await this.#draw(keys, signal);
    if (!signal.aborted) await this.#judge(keys, signal);
    if (!signal.aborted) await this.#cross(keys, signal);
  }

  #commands(keys: readonly string[]): Command[] {
    const tolerated = { question: "formulas", options: given({ amplitude: this.#amplitude(), tolerance: this.#form.value("tolerance") }) };
    const crossing = { question: "formulas", options: given({ crossovers: true, formulas: keys.join(",") }) };
    return [this.#period(keys), tolerated, crossing, this.#picture.picture.command(this.#figure(keys))];
  }

  #amplitude(): string {
    return this.#form.value("amplitude");
  }

  #period(keys: readonly string[], amplitude = this.#amplitude()): Command {
    return { question: "period", arguments: [amplitude], options: given({ formulas: keys.join(",") }) };
  }

  #figure(keys: readonly string[]): Command {
    const [from, to] = [this.#form.chosen("from"), this.#form.chosen("to")];
    return this.#picture.command(keys, { from, to, lowest: Number(this.#form.value("lowest")) });
  }

  async #draw(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const command = this.#figure(keys);
    if (JSON.stringify(command) === this.#drawn) return;
    const answer = await this.#picture.picture.draw(command, signal);
    if (signal.aborted) return;
    this.#drawn = JSON.stringify(command);
    this.#picture.lines();
    if (answer.status !== 0) this.#fail(this.#form.blame(answer));
  }

  async #judge(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const [tolerance, unit] = [this.#form.value("tolerance"), this.#form.value("unit")];
    const { answer, value: periods } = await read<Periods>(this.#engine, this.#period(keys), signal);
    const period = periods?.results[0];
    if (signal.aborted) return;
    if (answer.status !== 0 || period === undefined) return this.#fail(this.#form.blame(answer));
    const held = await read<Catalogue>(this.#engine, { question: "formulas", options: given({ tolerance, formulas: keys.join(",") }) }, signal);
    if (signal.aborted) return;
    if (held.answer.status !== 0) return this.#fail(this.#form.blame(held.answer));
    this.#catalogue = new Map(held.value?.formulas.map((formula) => [formula.key, formula]));
    const enough = await read<Catalogue>(this.#engine, { question: "formulas", options: given({ amplitude: this.#amplitude(), tolerance }) }, signal);
    if (signal.aborted) return;
    this.#say(period, enough.value?.formulas[0], tolerance, unit);
    this.#picture.mark(period.amplitude_rad / DEGREE, Number(tolerance), angle(period.amplitude_rad, unit));
    this.#values.replaceChildren(values(period, this.#catalogue, Number(tolerance), unit));
    this.#cards.replaceChildren(element("h2", {}, words.cards), ...keys.flatMap((key) => this.#catalogue.get(key) ?? []).map(card));
  }

  #say(period: Periods["results"][number], simplest: Formula | undefined, tolerance: string, unit: string): void {
    const exact = words.exact(angle(period.amplitude_rad, unit), digits(period.ratio, 12));
    const verdict = simplest === undefined ? words.noneSuffices(tolerance) : words.suffices(simplest.name, tolerance, limit(simplest, unit));
    this.#verdict.replaceChildren(element("p", {}, exact), element("p", {}, verdict));
  }

  async #cross(keys: readonly string[], signal: AbortSignal): Promise<void> {
    const asked = `${keys} ${this.#form.value("unit")}`;
    if (this.#crossed === asked) return;
    const title = element("h2", {}, words.crossovers);
    if (keys.length < 2) return this.#crossovers.replaceChildren(title, element("p", {}, words.onlyOne));
    const { value } = await read<Crossovers>(this.#engine, { question: "formulas", options: given({ crossovers: true, formulas: keys.join(",") }) }, signal);
    if (signal.aborted || value === undefined) return;
    this.#crossed = asked;
    this.#crossovers.replaceChildren(title, crossovers(value, this.#catalogue, this.#form.value("unit")));
  }

  #move(degrees: number): void {
    this.#form.put("amplitude", angleEntry(degrees));
    this.#picture.mark(degrees, Number(this.#form.value("tolerance")), angle(degrees * DEGREE, this.#form.value("unit")));
    this.#update();
  }

  #point(degrees: number | undefined): void {
    this.#pointing.run(async (signal) => {
      const keys = this.#selection.keys;
      if (degrees === undefined || keys.length === 0) return this.#under.replaceChildren(words.pictureHint);
      const { value } = await read<Periods>(this.#engine, this.#period(keys, angleEntry(degrees)), signal);
      const [period] = value?.results ?? [];
      if (period === undefined || signal.aborted) return;
      const errors = period.formulas.map((it) => `${this.#catalogue.get(it.key)?.name ?? it.key} ${digits(it.fractional_error, 2)}`);
      this.#under.replaceChildren(words.under(angle(period.amplitude_rad, this.#form.value("unit"), 5), errors.join(" · ")));
    });
  }

  async #saveValues(): Promise<void> {
    const keys = this.#selection.keys;
    if (keys.length === 0) return this.#fail(words.noneChosen);
    const answer = await ask(this.#engine, extended(this.#period(keys), { csv: true }));
    const failure = saveAnswer("formulas.csv", answer, "text/csv");
    if (failure !== "") this.#fail(this.#form.blame(answer));
  }

  #fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
  }
}

function fields() {
  return [
    textField({ key: "amplitude", option: "AMPLITUDE", words: words.amplitude, initial: "60deg", unit: "angle" }),
    textField({ key: "tolerance", option: "--tolerance", words: words.tolerance, initial: "1e-3" }),
    unitSwitch(),
    textField({ key: "from", option: "--from", words: words.from, initial: "0deg", unit: "angle" }),
    textField({ key: "to", option: "--to", words: words.to, initial: "180deg", unit: "angle" }),
    choiceField({ key: "lowest", option: "--lowest", words: words.lowest, initial: "1e-8" }, LOWEST.map((value) => [value, value])),
  ];
}
