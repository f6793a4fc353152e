// Room 3: exact series of any oscillator, compared with its exact motion.

import type { Address } from "../../address.ts";
import { type Answer, type Engine, text as decoded } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given } from "../../parts/command.ts";
import { explained } from "../../parts/marks.ts";
import { button, element, identifier } from "../../parts/element.ts";
import { copyButton, Equivalents } from "../../parts/equivalents.ts";
import { choiceField, type Field } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { inWords } from "../../parts/in_words.ts";
import { ladder } from "../../parts/ladder.ts";
import { isWanted, Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { fromHtml } from "../../parts/markup.ts";
import { Picture } from "../../parts/picture.ts";
import { saveAnswer } from "../../parts/save.ts";
import { SavedNumbers } from "../../parts/saved_numbers.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import { isOfAngle } from "../../parts/units.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import type { Backbone, Evaluation, Oscillators } from "./answers.ts";
import { equationOf, typeset } from "./equation.ts";
import { ANGLES, fields, ORDER, PLAIN } from "./fields.ts";
import { gaugeOf } from "./gauge.ts";
import { areSeries, backbone, evaluation, grouped } from "./results.ts";

const words = text.perturbation;
/** Highest order that is computed without stages, and the highest order. */
const [QUICK, MOST] = [15, 1000];
const LANGUAGES: readonly (readonly [format: string, name: string, ending: string])[] = [["python", "Python", "py"], ["c", "C", "c"], ["rust", "Rust", "rs"], ["fortran", "Fortran", "f90"]];

export const perturbation: Room = {
  name: "perturbation",
  open(place, address, engine) {
    const room = new PerturbationRoom(address, engine);
    place.append(...room.elements);
    room.begin();
    return () => room.leave();
  },
};

class PerturbationRoom {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #said: (sentence: string) => string;
  /** The field of the reader's own equation, hidden for built-in oscillators. */
  readonly #entry: Field | undefined;
  readonly #equation = element("div", { class: "scroll equation" });
  readonly #latest = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #builtIn = element("select", { id: identifier() });
  readonly #series: Finding;
  readonly #limits: Finding;
  readonly #backbone: Finding;
  readonly #seriesPicture: Picture;
  readonly #backbonePicture: Picture;
  readonly #numbers: Readonly<Record<"series" | "backbone", SavedNumbers>>;
  /** The buttons that save a series. */
  readonly #saving: HTMLElement;
  readonly #equivalents = new Equivalents();
  #latex = "";
  #builtIns: Oscillators["oscillators"] = [];
  /** The values of parameters that came with an equation. */
  #brought = "";
  /** The keys of built-in oscillators whose variable is an angle. */
  #angles: ReadonlySet<string> = new Set(["pendulum"]);

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    const all = fields();
    this.#said = inWords(all);
    this.#entry = all.find(({ key }) => key === "oscillator");
    this.#form = new Form(address, all, () => this.#update());
    this.#numbers = { series: new SavedNumbers(engine, "series"), backbone: new SavedNumbers(engine, "backbone") };
    this.#seriesPicture = new Picture(engine, "series", "output");
    this.#backbonePicture = new Picture(engine, "backbone");
    this.#saving = this.#savings();
    this.#series = new Finding(words.series, this.#saving);
    this.#limits = new Finding(words.limits, this.#seriesPicture.element);
    this.#backbone = new Finding(words.backbone, this.#backbonePicture.element, this.#numbers.backbone.element);
    const chooser = element("div", { class: "field" }, element("label", { for: this.#builtIn.id }, words.choose.label), this.#builtIn);
    const question = this.#form.part(words.question, ["oscillator", "set"], { open: true });
    question.firstElementChild?.after(chooser, this.#equation);
    scrolling(this.#equation);
    this.#entry?.element.toggleAttribute("hidden", !this.#form.value("oscillator").includes("="));
    const controls = [
      question,
      this.#form.part(words.expansion, ["order", "gauge", "letters", "about", "damping-order", "small", "resonance"]),
      this.#form.part(words.trial, ["evaluate", "quantity", "amplitudes", "unit"]),
    ];
    const findings = [this.#series, this.#limits, this.#backbone].map((finding) => finding.element);
    this.elements = layout(words.title, words.lead, controls, [this.#status.element, ...findings, this.#equivalents.element]);
  }

  begin(): void {
    const offered = async (signal: AbortSignal) => {
      const { value } = await read<Oscillators>(this.#engine, { question: "list", arguments: ["oscillators"] }, signal);
      this.#offer(value?.oscillators ?? []);
      await this.#answer(signal);
    };
    this.#latest.run((signal) => this.#status.during(offered(signal)));
  }

  leave(): void {
    this.#latest.stop();
  }

  #offer(oscillators: Oscillators["oscillators"]): void {
    this.#builtIns = oscillators;
    const options = oscillators.map(({ key, title }) => element("option", { value: key }, title));
    this.#builtIn.append(...options, element("option", { value: "" }, words.choose.own));
    this.#angles = new Set(oscillators.filter(({ equation }) => equation.includes("theta")).map(({ key }) => key));
    this.#fitChooser();
    this.#builtIn.addEventListener("change", () => this.#choose(this.#builtIn.value));
  }

  // An equation of the reader's own begins as that of the oscillator before, with its parameters.
  #choose(key: string): void {
    const before = this.#builtIns.find((it) => it.key === this.#form.value("oscillator"));
    const others = { letters: "", about: "", gauge: "", "damping-order": "", small: "", resonance: "" };
    if (key !== "") this.#put({ oscillator: key, set: "", ...others, ...(this.#angles.has(key) ? ANGLES : PLAIN) });
    else if (before !== undefined) {
      this.#brought = before.parameters.map((it) => `${it.name}=${it.default}`).join(",");
      this.#put({ oscillator: before.equation, set: this.#brought });
    }
    this.#update();
  }

  // Values that came with an equation go with their parameters; those of the reader stay.
  #drop(): void {
    if (this.#brought === "" || this.#form.value("set") !== this.#brought) return;
    const names: readonly string[] = this.#form.value("oscillator").match(/[a-z]\w*/gi) ?? [];
    this.#brought = this.#brought.split(",").filter((it) => names.includes(it.split("=")[0] ?? "")).join(",");
    this.#put({ set: this.#brought });
  }

  // The field of an equation is shown where the oscillator is not built in.
  #fitChooser(): void {
    const key = this.#form.value("oscillator");
    this.#builtIn.value = this.#builtIns.some((it) => it.key === key) ? key : "";
    if (this.#entry !== undefined) this.#entry.element.hidden = this.#builtIn.value !== "";
  }

  #put(values: Readonly<Record<string, string>>): void {
    for (const [key, value] of Object.entries(values)) this.#form.put(key, value);
  }

  #update(): void {
    this.#fitChooser();
    this.#drop();
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  // An equation without an angle is not evaluated at default angles, and the default order of series is too high for drives.
  #fit(): void {
    if (this.#form.value("resonance") !== "" && this.#form.value("order") === ORDER) this.#put({ order: "" });
    const isUntouched = Object.entries(ANGLES).every(([field, value]) => this.#form.value(field) === value);
    if (this.#form.value("oscillator").includes("=") && !this.#isOfAngle() && isUntouched) this.#put(PLAIN);
    this.#form.plain(this.#isOfAngle() ? [] : Object.keys(ANGLES));
  }

  /** `true` if the variable is an angle. */
  #isOfAngle(): boolean {
    const oscillator = this.#form.value("oscillator");
    return oscillator.includes("=") ? isOfAngle(oscillator) : this.#angles.has(oscillator);
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    this.#fit();
    if (this.#form.value("oscillator") === "") return this.#nothing(words.none);
    this.#equivalents.show([this.#expansion(), this.#evaluation(), this.#seriesPicture.command(this.#figure()), this.#backboneCommand()]);
    if (!(await this.#expand(signal)) || signal.aborted) return;
    if (this.#form.value("resonance") !== "") return this.#compareNothing();
    await this.#evaluate(signal);
    if (!signal.aborted) await this.#compare(signal);
  }

  /** Shows the reason why there is no series, which may also be shown next to its field, and removes the comparison. */
  #nothing(why: string): void {
    this.#series.show();
    this.#series.fail(this.#said(why));
    this.#equation.replaceChildren();
    this.#offerSaving(false);
    this.#compareNothing();
  }

  #compareNothing(): void {
    this.#limits.show();
    this.#seriesPicture.clear();
    this.#backbone.show();
    this.#backbonePicture.clear();
    this.#numbers.backbone.offer(undefined);
  }

  #about(): Command {
    const [oscillator, set, about] = ["oscillator", "set", "about"].map((key) => this.#form.value(key)) as [string, string, string];
    return { question: "", arguments: [oscillator], options: given({ set, about }) };
  }

  #expansion(order = this.#form.value("order")): Command {
    const value = (key: string) => this.#form.value(key);
    const flow = { "damping-order": value("damping-order"), small: value("small"), resonance: value("resonance") };
    return extended({ ...this.#about(), question: "expand" }, { letters: value("letters"), order, gauge: gaugeOf(value("gauge")), ...flow });
  }

  #evaluation(): Command {
    const value = (key: string) => this.#form.value(key);
    return extended({ ...this.#about(), question: "expand" }, { evaluate: value("evaluate"), quantity: value("quantity") === "period" ? "" : value("quantity") });
  }

  #figure(): Command {
    const quantity = this.#form.value("quantity");
    return extended({ ...this.#about(), question: "figure series" }, { quantity: quantity === "period" ? "" : quantity });
  }

  #backboneCommand(): Command {
    const value = (key: string) => this.#form.value(key);
    return extended({ ...this.#about(), question: "backbone" }, { amplitudes: value("amplitudes"), order: value("order") });
  }

  // Expands order by order, so that results are visible early. Returns `true` if there is a series.
  async #expand(signal: AbortSignal): Promise<boolean> {
    const last = Number(this.#form.value("order"));
    const earlier = Number.isInteger(last) && last > QUICK && last <= MOST ? ladder(last, QUICK).slice(0, -1) : [];
    for (const order of [...earlier.map(String), this.#form.value("order")]) {
      if (earlier.length > 0) this.#status.say(words.orders(Number(order), last));
      const asked = this.#expansion(order);
      const notes: string[] = [];
      let answer = await ask(this.#engine, extended(asked, { format: "mathml" }), { signal, onNote: (line) => notes.push(line) });
      const [equation = "", ...lines] = fromHtml(decoded(answer));
      const isPlain = answer.status === 0 && !areSeries(lines);
      if (isPlain && !signal.aborted) answer = await ask(this.#engine, asked, { signal });
      // A cancelled series is valid up to its last order.
      if (signal.aborted && (!isWanted(signal) || answer.output.length === 0)) return false;
      if (answer.status !== 0 && !signal.aborted) {
        this.#nothing(this.#form.blame(answer));
        return false;
      }
      this.#offerSaving(true);
      this.#latex = "";
      const latex = decoded(await ask(this.#engine, extended(isPlain ? asked : this.#expansion("3"), { latex: true }), { signal }));
      const shown = isPlain ? flow(decoded(answer), latex) : grouped(lines);
      this.#equation.replaceChildren(equationOf(latex) ?? equation);
      this.#series.show(...notes.map((note) => element("p", { class: "quiet" }, this.#said(note))), element("div", { class: "series scroll", tabindex: "0", role: "region", "aria-label": words.series }, ...shown));
      if (signal.aborted) return false;
    }
    return true;
  }

  async #evaluate(signal: AbortSignal): Promise<void> {
    const { answer, value } = await read<Evaluation>(this.#engine, this.#evaluation(), signal);
    if (signal.aborted) return;
    if (value === undefined || answer.status !== 0) {
      this.#seriesPicture.clear();
      return this.#limits.fail(this.#onTrial(answer));
    }
    this.#limits.show(...evaluation(value));
    const drawn = await this.#seriesPicture.draw(this.#figure(), signal);
    if (drawn.status !== 0 && !signal.aborted) this.#seriesPicture.clear();
  }

  async #compare(signal: AbortSignal): Promise<void> {
    const asked = this.#backboneCommand();
    const { answer, value } = await this.#backbonePicture.read<Backbone>(asked, signal);
    if (signal.aborted) return;
    this.#numbers.backbone.offer(value === undefined ? undefined : asked);
    if (value === undefined || answer.status !== 0) {
      this.#backbonePicture.clear();
      return this.#backbone.fail(this.#onTrial(answer));
    }
    this.#backbone.show(backbone(value, this.#isOfAngle(), this.#form.value("unit")));
  }

  // The series exists: only the options of the evaluation can be wrong. The error is shown in the part as well, since the field may be far away.
  #onTrial(answer: Answer): string {
    this.#form.blame(answer, ["evaluate", "quantity", "amplitudes"]);
    return this.#said(explained(answer.error));
  }

  #offerSaving(is: boolean): void {
    this.#saving.hidden = !is;
    this.#numbers.series.offer(is ? this.#expansion() : undefined);
  }

  #savings(): HTMLElement {
    const language = choiceField({ key: "language", words: { label: words.code.label } }, LANGUAGES.map(([format, name]) => [format, name]));
    language.value = "python";
    const saved = button(words.code.save, () => void this.#saveCode(language.value));
    const copy = copyButton(() => this.#latex, words.copyLatex);
    // The LaTeX is queried when the pointer or the focus reaches the button, so that a press copies at once.
    for (const event of ["pointerenter", "focus"]) copy.addEventListener(event, () => void this.#readLatex());
    const latex = element("span", {}, `${words.copyLatex}: `, copy);
    return element("div", { class: "screen-only", hidden: true }, element("p", { class: "buttons" }, latex), this.#numbers.series.element, element("div", { class: "code-choice" }, language.element, saved));
  }

  async #readLatex(): Promise<void> {
    if (this.#latex === "") this.#latex = decoded(await ask(this.#engine, extended(this.#expansion(), { latex: true })));
  }

  async #saveCode(format: string): Promise<void> {
    const answer = await ask(this.#engine, extended(this.#expansion(), { format }));
    const ending = LANGUAGES.find(([it]) => it === format)?.[2] ?? "txt";
    const failure = saveAnswer(`series.${ending}`, answer, "text/plain");
    if (failure !== "") this.#series.fail(failure);
  }
}

/** A slow flow: its formulas as mathematics, and all that the command says of it as text. */
function flow(written: string, latex: string): Node[] {
  return [...typeset(latex).slice(1), element("details", {}, element("summary", {}, words.asText), element("pre", { tabindex: "0" }, written))];
}
