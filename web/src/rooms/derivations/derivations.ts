// Room 4: derivations step by step, and the check of two published ones.

import type { Address } from "../../address.ts";
import { type Engine, text as decoded } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { Form } from "../../parts/form.ts";
import { inWords } from "../../parts/in_words.ts";
import { Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { explained } from "../../parts/marks.ts";
import { fromHtml } from "../../parts/markup.ts";
import { saveAnswer } from "../../parts/save.ts";
import { SavedNumbers } from "../../parts/saved_numbers.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import { isOfAngle } from "../../parts/units.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { gaugeOf } from "../perturbation/gauge.ts";
import { fields, OWN_KEYS, PAPER_KEYS, SERIES_KEYS, taken } from "./fields.ts";
import { type Paper, statements } from "./statements.ts";
import { Steps } from "./steps.ts";

const words = text.derivations;
const ENDINGS = { html: "html", latex: "tex", markdown: "md", ipynb: "ipynb" } as const;

export const derivations: Room = {
  name: "derivations",
  open(place, address, engine) {
    const room = new DerivationsRoom(address, engine);
    place.append(...room.elements);
    room.begin();
    return () => room.leave();
  },
};

class DerivationsRoom {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #said: (sentence: string) => string;
  readonly #latest = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #steps: Steps;
  readonly #found: Finding;
  readonly #stepButtons: HTMLElement;
  readonly #saving: HTMLElement;
  readonly #numbers: SavedNumbers;
  readonly #equivalents = new Equivalents();
  readonly #parts: readonly (readonly [HTMLElement, readonly string[]])[];

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    const all = fields();
    this.#said = inWords(all);
    this.#form = new Form(address, all, () => this.#update());
    this.#steps = new Steps(address, (answer) => this.#judge(answer));
    this.#found = new Finding(undefined);
    const ended = element("span", { role: "status" });
    const next = () => (ended.textContent = this.#steps.next() ? "" : words.ended);
    this.#stepButtons = element("p", { class: "buttons screen-only sticky" }, button(words.next, next, { class: "main" }), button(words.all, () => this.#steps.setAll(true)), button(words.fold, () => this.#steps.setAll(false)), ended);
    const kinds = Object.keys(ENDINGS) as (keyof typeof ENDINGS)[];
    this.#saving = element("p", { class: "buttons screen-only" }, `${words.save} `, ...kinds.map((kind) => button(words.kinds[kind], () => void this.#save(kind))));
    this.#numbers = new SavedNumbers(engine, "statements");
    const road = this.#form.part(words.question, ["road", ...SERIES_KEYS], { open: true });
    const own = this.#form.part(words.own, OWN_KEYS);
    const paper = this.#form.part(words.statements, PAPER_KEYS);
    this.#parts = [[road, SERIES_KEYS], [own, OWN_KEYS], [paper, PAPER_KEYS]];
    const results = [this.#status.element, this.#stepButtons, this.#found.element, this.#saving, this.#numbers.element, this.#equivalents.element];
    this.elements = layout(words.title, words.lead, [road, own, paper], results);
    this.#offer(all, address);
    this.#offerSaving(false, false);
  }

  begin(): void {
    this.#update();
  }

  leave(): void {
    this.#latest.stop();
  }

  // Only the fields of the chosen method are shown.
  #offer(all: ReturnType<typeof fields>, address: Address): void {
    const show = () => {
      const keys = taken(this.#form.value("road"));
      for (const { key, element: field } of all) field.hidden = key !== "road" && !keys.includes(key);
      for (const [part, its] of this.#parts.slice(1)) part.hidden = !its.some((key) => keys.includes(key));
    };
    show();
    all[0]?.onChange(() => {
      show();
      address.put({ at: undefined, steps: undefined });
    });
  }

  #update(): void {
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    const isPaper = this.#form.value("road") === "paper";
    this.#form.plain(this.#isOfAngle() ? [] : ["amplitude"]);
    this.#equivalents.show([this.#command()]);
    if (isPaper) await this.#check(signal);
    else await this.#derive(signal);
  }

  /** `true` if the amplitude is an angle: for the pendulum, and for equations in an angle. */
  #isOfAngle(): boolean {
    const oscillator = taken(this.#form.value("road")).includes("oscillator") ? this.#form.value("oscillator") : "";
    return oscillator === "" || oscillator === "pendulum" || isOfAngle(oscillator);
  }

  #command(): Command {
    const road = this.#form.value("road");
    const value = (key: string) => (key === "gauge" ? gaugeOf(this.#form.value(key)) : this.#form.value(key));
    const options = Object.fromEntries(taken(road).filter((key) => key !== "oscillator").map((key) => [key, value(key)]));
    if (road === "paper") return { question: "paper", options: given(options) };
    const { exercises, ...others } = options;
    const oscillator = taken(road).includes("oscillator") ? this.#form.value("oscillator") : "";
    return { question: "derive", arguments: oscillator === "" ? [] : [oscillator], options: given({ method: road, ...others, exercises: exercises === "yes" }) };
  }

  async #derive(signal: AbortSignal): Promise<void> {
    const notes: string[] = [];
    const answer = await ask(this.#engine, extended(this.#command(), { format: "html" }), { signal, onNote: (line) => notes.push(line) });
    if (signal.aborted) return;
    this.#offerSaving(answer.status === 0, false);
    if (answer.status !== 0) return this.#found.fail(this.#said(this.#form.blame(answer)));
    this.#found.show(...notes.map((note) => element("p", { class: "quiet" }, this.#said(note))), this.#steps.element);
    this.#steps.show(decoded(answer));
  }

  /** The judgement of an answer to an exercise, as the command writes it. */
  async #judge(text: string): Promise<Node[]> {
    const answer = await this.#status.during(ask(this.#engine, extended(this.#command(), { format: "html", answer: text })));
    return answer.status === 0 ? fromHtml(decoded(answer)) : [element("p", { class: "wrong" }, this.#said(explained(answer.error)))];
  }

  async #check(signal: AbortSignal): Promise<void> {
    const { answer, value } = await read<Paper>(this.#engine, this.#command(), signal);
    if (signal.aborted) return;
    this.#offerSaving(false, value !== undefined);
    if (value === undefined) return this.#found.fail(this.#said(this.#form.blame(answer)));
    this.#found.show(...statements(value, this.#said));
  }

  #offerSaving(derivation: boolean, table: boolean): void {
    this.#stepButtons.hidden = this.#saving.hidden = !derivation;
    this.#numbers.offer(table ? this.#command() : undefined);
  }

  async #save(kind: keyof typeof ENDINGS): Promise<void> {
    const answer = await ask(this.#engine, extended(this.#command(), { format: kind }));
    const failure = saveAnswer(`derivation.${ENDINGS[kind]}`, answer, kind === "html" ? "text/html" : "text/plain");
    if (failure !== "") this.#found.fail(this.#said(failure));
  }
}
