// Room 6: regular and chaotic motion: the bifurcation diagram over a parameter, and the motion at one of its values.

import type { Address } from "../../address.ts";
import { type Answer, type Engine, text as decoded } from "../../engine/engine.ts";
import { choice } from "../../parts/choice.ts";
import { ask, type Command } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { BESIDE, Form } from "../../parts/form.ts";
import { ladder } from "../../parts/ladder.ts";
import { isWanted, Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { digits } from "../../parts/numbers.ts";
import { Picture } from "../../parts/picture.ts";
import { PictureSlider } from "../../parts/picture_slider.ts";
import { NumbersTable } from "../../parts/numbers_table.ts";
import { plain } from "../../parts/plain.ts";
import { SavedNumbers } from "../../parts/saved_numbers.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { fields, PARTS, preset } from "./fields.ts";
import { FleetPanel } from "./fleet/panel.ts";
import { FurtherFindings } from "./further.ts";
import { OrbitFinding } from "./orbit.ts";
import { Questions } from "./questions.ts";
import { range, stages, written } from "./range.ts";
import { said } from "./said.ts";
import { Sliders } from "./sliders.ts";
import { ValueKeeper } from "./value_keeper.ts";

const words = text.chaos;
/** Number of points with which a section begins, and the largest number. */
const [FIRST, MOST] = [50, 1e7];
/** Ways to follow attractors from one value to the next. */
const SWEEPS = ["both", "up", "down", ""] as const;

/** The result of `libration lyapunov`. */
interface Exponent {
  readonly exponent_per_s: number;
  readonly exponent_uncertainty_per_s: number;
  readonly verdict: "regular" | "chaotic" | "undecided";
  readonly reason: string;
}

/** The parts of the results, each with a picture. */
type Part = "diagram" | "section" | "neighbours" | "verdict";
/** The parts with numbers to save. */
type Numbered = Exclude<Part, "neighbours">;

export const chaos: Room = {
  name: "chaos",
  open(place, address, engine) {
    const room = new ChaosRoom(address, engine);
    place.append(...room.elements);
    room.update();
    return () => room.leave();
  },
};

class ChaosRoom {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #latest = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #pictures: Readonly<Record<Part, Picture>>;
  readonly #findings: Readonly<Record<Part, Finding>>;
  readonly #numbers: Readonly<Record<Numbered, SavedNumbers>>;
  readonly #slider: PictureSlider;
  readonly #equivalents = new Equivalents();
  readonly #neighbours = new NumbersTable(async () => decoded(await ask(this.#engine, this.#questions.followed())));
  readonly #sweeps = element("div");
  readonly #preset = element("select", { id: "chaos-preset" });
  readonly #fleet: FleetPanel;
  readonly #orbit: OrbitFinding;
  readonly #questions: Questions;
  readonly #value: ValueKeeper;
  readonly #sliders: Sliders;
  readonly #further: FurtherFindings;
  #drawn = "";

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    this.#form = new Form(address, fields(), () => this.update());
    this.#questions = new Questions(this.#form);
    this.#value = new ValueKeeper(this.#form);
    this.#sliders = new Sliders(this.#form, () => this.#move());
    const picture = (name: string, option: "figure" | "output" = "figure") => new Picture(engine, name, option);
    this.#pictures = { diagram: picture("bifurcation"), section: picture("section"), neighbours: picture("neighbours", "output"), verdict: picture("lyapunov") };
    this.#numbers = { diagram: new SavedNumbers(engine, "bifurcation"), section: new SavedNumbers(engine, "section"), verdict: new SavedNumbers(engine, "lyapunov") };
    const { diagram, section, neighbours, verdict } = this.#pictures;
    const look = (part: Part) => element("p", { class: "look" }, words.look[part]);
    this.#findings = {
      diagram: new Finding(words.diagram, look("diagram"), this.#sweeps, diagram.element, this.#numbers.diagram.element, this.#numbers.diagram.table.element),
      section: new Finding(words.section, look("section"), section.element, this.#numbers.section.element, this.#numbers.section.table.element),
      neighbours: new Finding(words.neighbours, look("neighbours"), neighbours.element, this.#neighbours.element),
      verdict: new Finding(words.verdict, look("verdict"), verdict.element, this.#numbers.verdict.element, this.#numbers.verdict.table.element),
    };
    this.#slider = this.#slides(diagram);
    this.#slider.rest();
    this.#orbit = new OrbitFinding(engine);
    this.#further = new FurtherFindings(engine, this.#form, this.#questions);
    this.#fleet = new FleetPanel(address, engine, this.#sliders.element, () => this.#equal());
    const controls = [this.#form.part(words.question, PARTS.system), this.#fleet.fields, this.#form.part(words.diagramChoices, PARTS.diagram), this.#form.part(words.choices, PARTS.chosen), ...this.#further.fields];
    // On a narrow page the motion comes before the fields.
    const [first, later] = matchMedia(BESIDE).matches ? [controls, []] : [[], controls];
    // Findings with fields of their own come first, since the reader has asked for them.
    const found = [...this.#further.elements, ...Object.values(this.#findings).map((finding) => finding.element), this.#orbit.element];
    this.elements = layout(words.title, words.lead, [this.#presets(), ...first], [this.#status.element, this.#fleet.element, element("div", {}, ...later), element("div", { class: "pairs" }, ...found), this.#equivalents.element]);
  }

  update(): void {
    this.#value.keep();
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  leave(): void {
    this.#latest.stop();
    this.#fleet.close();
  }

  // The pendulum follows a slider at once, the pictures later.
  #move(): void {
    this.#swing();
    this.update();
  }

  #swing(): void {
    this.#fleet.show(this.#questions.chosen("simulate", []), this.#questions.starts());
  }

  #presets(): HTMLElement {
    const options = Object.entries(words.presets).map(([key, name]) => element("option", { value: key }, name));
    this.#preset.append(element("option", { value: "" }, words.preset.own), ...options);
    this.#preset.addEventListener("change", () => {
      for (const [key, value] of Object.entries(preset(this.#preset.value) ?? {})) this.#form.put(key, value);
      this.#value.forget();
      this.update();
    });
    return element("div", { class: "field" }, element("label", { for: "chaos-preset" }, words.preset.label), this.#preset);
  }

  #slides(picture: Picture): PictureSlider {
    const known = () => range(this.#form.value("over")) ?? { name: "", from: 0, to: 1, step: 1 };
    return new PictureSlider(picture, "", {
      nearest: (value) => Number(written(known(), value)),
      steps: () => ({ usual: known().step, fine: known().step / 10, coarse: known().step * 10 }),
      moved: (value) => {
        this.#form.put("value", written(known(), value));
        this.#mark();
        this.update();
      },
    });
  }

  // Marks the chosen value in the diagram.
  #mark(): void {
    const known = range(this.#form.value("over"));
    const written = this.#form.value("value");
    const value = written === "" || !Number.isFinite(Number(written)) ? undefined : Number(written);
    const frame = this.#pictures.diagram.axis();
    if (known === undefined || frame === undefined) return this.#slider.rest();
    this.#slider.axis = frame;
    this.#slider.put(value, written === "" ? words.noValue : words.sliderWords(known.name, written), words.sliderLabel(known.name));
    this.#pictures.diagram.overlay(this.#slider.line());
  }

  // The preset whose values are in the fields, whatever value is chosen in its diagram.
  #presetNow(): string {
    const isNow = (key: string) => Object.entries(preset(key) ?? {}).every(([field, value]) => field === "value" || this.#form.value(field) === value);
    return Object.keys(words.presets).find(isNow) ?? "";
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    this.#preset.value = this.#presetNow();
    this.#sliders.show();
    this.#equal();
    const isSystem = await this.#grow(signal);
    if (signal.aborted) return;
    // An invalid system is reported once.
    if (!isSystem) return this.#nothing();
    this.#further.expect();
    this.#swing();
    await this.#judge(signal);
    if (!signal.aborted) await this.#compare(signal);
    if (!signal.aborted) await this.#draw(signal);
    if (!signal.aborted) await this.#orbit.find(this.#questions.orbit(), signal);
    if (!signal.aborted) await this.#further.find(signal);
  }

  #equal(): void {
    const ask = this.#questions;
    const commands = [this.#fleet.command(), this.#form.value("over") === "" ? undefined : ask.diagram(), ask.section(), ask.neighbours(), ask.lyapunov(), ask.orbit(), ...this.#further.commands()];
    this.#equivalents.show(commands.filter((command) => command !== undefined));
  }

  // Each stage is the same section with fewer points, so that it grows. Returns `true` if the query was valid.
  async #grow(signal: AbortSignal): Promise<boolean> {
    const last = Number(this.#form.value("points"));
    const earlier = Number.isInteger(last) && last > FIRST && last <= MOST ? ladder(last, FIRST).slice(0, -1) : [];
    for (const asked of [...earlier.map(String), this.#form.value("points")]) {
      if (earlier.length > 0) this.#status.say(words.growing(Number(asked), last));
      const answer = await this.#pictures.section.draw(this.#questions.section(asked), signal);
      this.#offer("section", this.#questions.section());
      if (signal.aborted) return true;
      this.#findings.section.fail("");
      if (answer.status === 0) continue;
      this.#fail("section", answer, ["system", "set", "initial", "at", "points"]);
      return answer.output.length > 0 || answer.error.parameters.includes("--points");
    }
    return true;
  }

  async #judge(signal: AbortSignal): Promise<void> {
    const { answer, value } = await this.#pictures.verdict.read<Exponent>(this.#questions.lyapunov(), signal);
    if (!isWanted(signal) || (signal.aborted && value === undefined)) return;
    if (value === undefined) return this.#fail("verdict", answer, ["intervals"]);
    this.#numbers.verdict.offer(this.#questions.lyapunov());
    const { verdict } = value;
    this.#findings.verdict.show(
      element("p", { class: "verdict" }, words.because(words[verdict], plain(value.reason))),
      element("p", {}, words.exponent(digits(value.exponent_per_s, 4), digits(value.exponent_uncertainty_per_s, 2))),
    );
  }

  async #compare(signal: AbortSignal): Promise<void> {
    const answer = await this.#pictures.neighbours.draw(this.#questions.neighbours(), signal);
    if (signal.aborted) return;
    this.#findings.neighbours.fail("");
    this.#neighbours.offer(answer.status === 0);
    if (answer.status !== 0) this.#fail("neighbours", answer, ["until"]);
  }

  // The diagram, in stages too; it does not change with the value chosen in it.
  async #draw(signal: AbortSignal): Promise<void> {
    const over = this.#form.value("over");
    if (over === "") {
      this.#forget("diagram");
      return this.#findings.diagram.show(element("p", { class: "quiet" }, words.noDiagram));
    }
    this.#sweeps.replaceChildren(this.#followed());
    const command = JSON.stringify(this.#questions.diagram());
    if (command === this.#drawn) return this.#mark();
    for (const stage of stages(over)) {
      const answer = await this.#pictures.diagram.draw(this.#questions.diagram(stage), signal);
      this.#refine();
      this.#offer("diagram", this.#questions.diagram());
      if (signal.aborted) return;
      this.#findings.diagram.show();
      if (answer.status !== 0) return this.#fail("diagram", answer, ["over", "each", "sweep"]);
      this.#mark();
    }
    this.#drawn = command;
  }

  // The attractor that the diagram follows: one at a time, or both.
  #followed(): HTMLElement {
    const now = this.#form.value("sweep");
    const press = (sweep: (typeof SWEEPS)[number]) => {
      this.#form.put("sweep", sweep);
      this.update();
      this.#sweeps.querySelector<HTMLElement>(`button:nth-of-type(${SWEEPS.indexOf(sweep) + 1})`)?.focus();
    };
    return choice(words.follow.question, SWEEPS.map((sweep) => [words.follow[sweep === "" ? "none" : sweep], sweep === now, () => press(sweep)]));
  }

  // Fine points, so that dense parts stay readable; saved pictures are the command's.
  #refine(): void {
    for (const points of this.#pictures.diagram.svg?.querySelectorAll("path.markers") ?? []) {
      points.setAttribute("stroke-width", "1.1");
      points.setAttribute("stroke-opacity", "0.75");
    }
  }

  #fail(part: Part, answer: Answer, keys: readonly string[]): void {
    const blamed = this.#form.blame(answer, keys);
    this.#findings[part].fail(blamed === "" ? text.parts.seeField : said(answer));
    if (answer.output.length === 0) this.#forget(part);
  }

  #nothing(): void {
    this.#fleet.clear();
    this.#orbit.clear();
    this.#further.clear();
    for (const part of ["verdict", "neighbours", "diagram"] as const) {
      this.#findings[part].show();
      this.#forget(part);
    }
  }

  #forget(part: Part): void {
    this.#pictures[part].clear();
    if (part === "diagram") {
      this.#drawn = "";
      this.#slider.rest();
    }
    if (part !== "neighbours") this.#numbers[part].offer(undefined);
  }

  // Offers the numbers of a picture, if it is shown.
  #offer(part: Numbered, command: Command): void {
    this.#numbers[part].offer(this.#pictures[part].svg === undefined ? undefined : command);
  }
}
