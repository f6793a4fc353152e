// Room 6: where order ends: the diagram of a parameter, and the motion at one of its values.

import type { Address } from "../../address.ts";
import type { Answer, Engine } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given, type Option, reason } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import { Form } from "../../parts/form.ts";
import { ladder } from "../../parts/ladder.ts";
import { isWanted, Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { digits } from "../../parts/numbers.ts";
import { Picture } from "../../parts/picture.ts";
import { PictureSlider } from "../../parts/picture_slider.ts";
import { save } from "../../parts/save.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { fields, PARTS, preset } from "./fields.ts";
import { FleetPanel } from "./fleet/panel.ts";
import { Orbits } from "./orbits.ts";
import { range, stages, written } from "./range.ts";

const words = text.chaos;
/** A section begins with so many points and grows from there. */
const FIRST = 50;

/** An answer of `libration lyapunov`. */
interface Exponent {
  readonly exponent: number;
  readonly uncertainty: number;
  readonly verdict: "regular" | "chaotic" | "undecided";
  readonly reason: string;
}

/** What is found, each with a picture. */
type Part = "diagram" | "section" | "neighbours" | "verdict";

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
  readonly #slider: PictureSlider;
  readonly #equivalents = new Equivalents();
  readonly #preset = element("select", { id: "chaos-preset" });
  readonly #fleet: FleetPanel;
  readonly #orbits: Orbits;
  #drawn = "";

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    this.#engine = engine;
    this.#form = new Form(address, fields(), () => this.update());
    const picture = (name: string, option: "figure" | "output" = "figure") => new Picture(engine, name, option);
    this.#pictures = { diagram: picture("bifurcation"), section: picture("section"), neighbours: picture("neighbours", "output"), verdict: picture("lyapunov") };
    const csv = (name: string, command: () => Command) => element("p", { class: "buttons screen-only" }, button(text.parts.saveData, () => void this.#saveCsv(name, command())));
    const { diagram, section, neighbours, verdict } = this.#pictures;
    this.#findings = {
      diagram: new Finding(words.diagram, diagram.element, csv("bifurcation", () => this.#diagram())),
      section: new Finding(words.section, section.element, csv("section", () => this.#section())),
      neighbours: new Finding(words.neighbours, neighbours.element),
      verdict: new Finding(words.verdict, verdict.element, csv("lyapunov", () => this.#lyapunov())),
    };
    this.#slider = this.#slides(diagram);
    this.#orbits = new Orbits(engine, this.#form);
    this.#fleet = new FleetPanel(address, engine, () => this.#equal());
    const controls = [this.#presets(), this.#form.part(words.question, PARTS.system), this.#fleet.fields, this.#form.part(words.diagramChoices, PARTS.diagram), this.#form.part(words.choices, PARTS.chosen)];
    const found = [...Object.values(this.#findings).map((finding) => finding.element), ...this.#orbits.elements];
    this.elements = layout(words.title, words.lead, controls, [this.#status.element, this.#fleet.element, element("div", { class: "pairs" }, ...found), this.#equivalents.element]);
  }

  update(): void {
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  leave(): void {
    this.#latest.stop();
    this.#fleet.close();
  }

  #presets(): HTMLElement {
    const options = Object.entries(words.presets).map(([key, name]) => element("option", { value: key }, name));
    this.#preset.append(element("option", { value: "" }, words.preset.own), ...options);
    this.#preset.addEventListener("change", () => {
      for (const [key, value] of Object.entries(preset(this.#preset.value) ?? {})) this.#form.put(key, value);
      this.update();
    });
    return element("div", { class: "field" }, element("label", { for: "chaos-preset" }, words.preset.label), this.#preset);
  }

  #slides(picture: Picture): PictureSlider {
    const known = () => range(this.#form.value("over")) ?? { name: "", from: 0, to: 1, step: 1 };
    return new PictureSlider(picture, words.sliderLabel(known().name), {
      nearest: (value) => Number(written(known(), value)),
      steps: () => ({ usual: known().step, fine: known().step / 10, coarse: known().step * 10 }),
      moved: (value) => {
        this.#form.put("value", written(known(), value));
        this.#mark();
        this.update();
      },
    });
  }

  // Where the chosen value is in the diagram.
  #mark(): void {
    const known = range(this.#form.value("over"));
    const value = Number(this.#form.value("value"));
    const frame = this.#pictures.diagram.axis();
    if (known === undefined || frame === undefined || this.#form.value("value") === "") return;
    this.#slider.axis = frame;
    this.#slider.put(value, words.sliderWords(known.name, this.#form.value("value")));
    this.#pictures.diagram.overlay(this.#slider.line());
  }

  // The one whose values stand in the fields, whatever value is chosen in its diagram.
  #presetNow(): string {
    const isNow = (key: string) => Object.entries(preset(key) ?? {}).every(([field, value]) => field === "value" || this.#form.value(field) === value);
    return Object.keys(words.presets).find(isNow) ?? "";
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    this.#preset.value = this.#presetNow();
    this.#equal();
    const isSystem = await this.#grow(signal);
    if (signal.aborted) return;
    // What is no system is said once.
    if (!isSystem) return this.#nothing();
    this.#fleet.show(this.#chosen("simulate", []), this.#starts());
    await this.#judge(signal);
    if (!signal.aborted) await this.#compare(signal);
    if (!signal.aborted) await this.#draw(signal);
    if (!signal.aborted) await this.#orbits.find(this.#orbit(), signal);
    if (!signal.aborted) await this.#orbits.follow(this.#response(), signal);
  }

  #equal(): void {
    const commands = [this.#fleet.command(), this.#form.value("over") === "" ? undefined : this.#diagram(), this.#section(), this.#neighbours(), this.#lyapunov(), this.#orbit(), this.#response()];
    this.#equivalents.show(commands.filter((command) => command !== undefined));
  }

  #starts(): string[] {
    return this.#form.value("initial").split(";").map((it) => it.trim()).filter((it) => it !== "");
  }

  #system(question: string, starts: readonly string[], set: readonly string[]): Command {
    const initial = starts.map((start): Option => ["initial", start]);
    return { question, arguments: [this.#form.value("system")], options: [...given({ set: set.filter((it) => it !== "").join(",") }), ...initial] };
  }

  // At the chosen value of the parameter.
  #chosen(question: string, starts: readonly string[]): Command {
    const [name, value] = [this.#form.value("over").split("=")[0]?.trim() ?? "", this.#form.value("value")];
    return this.#system(question, starts, [this.#form.value("set"), name === "" || value === "" ? "" : `${name}=${value}`]);
  }

  #diagram(over = this.#form.value("over")): Command {
    const value = (key: string) => this.#form.value(key);
    return extended(this.#system("bifurcation", this.#starts().slice(0, 1), [value("set")]), { over, points: value("each"), sweep: value("sweep"), at: value("at") });
  }

  #section(points = this.#form.value("points")): Command {
    return extended(this.#chosen("section", this.#starts()), { at: this.#form.value("at"), points });
  }

  #neighbours(): Command {
    return extended(this.#chosen("figure trajectories", this.#starts()), { until: this.#form.value("until") });
  }

  #orbit(): Command {
    return this.#chosen("orbit", this.#starts().slice(0, 1));
  }

  #response(): Command | undefined {
    const over = this.#form.value("response");
    return over === "" ? undefined : extended(this.#system("response", this.#starts().slice(0, 1), [this.#form.value("set")]), { over });
  }

  #lyapunov(): Command {
    return extended(this.#chosen("lyapunov", this.#starts().slice(0, 1)), { intervals: this.#form.value("intervals") });
  }

  // Each stage is the section with fewer points: the same ones, so that it grows. Whether the question was understood.
  async #grow(signal: AbortSignal): Promise<boolean> {
    const last = Number(this.#form.value("points"));
    const earlier = Number.isInteger(last) && last > FIRST ? ladder(last, FIRST).slice(0, -1) : [];
    for (const asked of [...earlier.map(String), this.#form.value("points")]) {
      if (earlier.length > 0) this.#status.say(words.growing(Number(asked), last));
      const answer = await this.#pictures.section.draw(this.#section(asked), signal);
      if (signal.aborted) return true;
      this.#findings.section.fail("");
      if (answer.status === 0) continue;
      this.#fail("section", answer, ["system", "set", "initial", "at", "points"]);
      return answer.output.length > 0 || answer.error.includes("--points");
    }
    return true;
  }

  async #judge(signal: AbortSignal): Promise<void> {
    const { answer, value } = await read<Exponent>(this.#engine, this.#lyapunov(), signal);
    if (!isWanted(signal) || (signal.aborted && value === undefined)) return;
    if (value === undefined) return this.#fail("verdict", answer, ["intervals"]);
    const { verdict } = value;
    this.#findings.verdict.show(
      element("p", { class: "verdict" }, words.because(words[verdict], value.reason)),
      element("p", {}, words.exponent(digits(value.exponent, 4), digits(value.uncertainty, 2))),
    );
    if (!signal.aborted) await this.#pictures.verdict.draw(this.#lyapunov(), signal);
  }

  async #compare(signal: AbortSignal): Promise<void> {
    const answer = await this.#pictures.neighbours.draw(this.#neighbours(), signal);
    if (signal.aborted) return;
    this.#findings.neighbours.fail("");
    if (answer.status !== 0) this.#fail("neighbours", answer, ["until"]);
  }

  // The diagram in stages too; it does not change with the value that is chosen in it.
  async #draw(signal: AbortSignal): Promise<void> {
    const over = this.#form.value("over");
    if (over === "") {
      this.#pictures.diagram.clear();
      return this.#findings.diagram.show(element("p", { class: "quiet" }, words.noDiagram));
    }
    const command = JSON.stringify(this.#diagram());
    if (command === this.#drawn) return this.#mark();
    for (const stage of stages(over)) {
      const answer = await this.#pictures.diagram.draw(this.#diagram(stage), signal);
      if (signal.aborted) return;
      this.#findings.diagram.fail("");
      if (answer.status !== 0) return this.#fail("diagram", answer, ["over", "each", "sweep"]);
      this.#mark();
    }
    this.#drawn = command;
  }

  #fail(part: Part, answer: Answer, keys: readonly string[]): void {
    this.#findings[part].fail(this.#form.blame(answer, keys) || reason(answer));
    if (answer.output.length === 0) this.#forget(part);
  }

  #nothing(): void {
    this.#fleet.clear();
    this.#orbits.clear();
    for (const part of ["verdict", "neighbours", "diagram"] as const) {
      this.#findings[part].show();
      this.#forget(part);
    }
  }

  #forget(part: Part): void {
    this.#pictures[part].clear();
    if (part === "diagram") this.#drawn = "";
  }

  async #saveCsv(name: string, command: Command): Promise<void> {
    save(`${name}.csv`, (await ask(this.#engine, extended(command, { csv: true }))).output, "text/csv");
  }
}
