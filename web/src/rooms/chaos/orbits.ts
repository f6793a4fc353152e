// Periodic motions: the orbit at the chosen value, and the answers of a driven system over a parameter, with the jumps of slow sweeps.

import type { Answer, Engine } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, reason } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import type { Form } from "../../parts/form.ts";
import { isWanted } from "../../parts/latest.ts";
import { Finding } from "../../parts/layout.ts";
import { digits } from "../../parts/numbers.ts";
import { Picture } from "../../parts/picture.ts";
import { save } from "../../parts/save.ts";
import { text } from "../../texts/en.ts";

const words = text.chaos;

/** An answer of `libration orbit`. */
interface Orbit {
  readonly period_s: number;
  readonly stability: string | null;
  /** Real and imaginary parts. */
  readonly multipliers: readonly (readonly [number, number])[];
}

/** An answer of `libration response`. */
interface Response {
  readonly parameter: string;
  readonly jumps: readonly { readonly parameter: number; readonly sweep: string; readonly from: number; readonly to: readonly number[] }[];
}

export class Orbits {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #form: Form;
  readonly #pictures: { readonly orbit: Picture; readonly response: Picture };
  readonly #orbit: Finding;
  readonly #response: Finding;
  #asked: { orbit?: Command; response?: Command } = {};
  #followed = "";

  constructor(engine: Engine, form: Form) {
    [this.#engine, this.#form] = [engine, form];
    this.#pictures = { orbit: new Picture(engine, "orbit"), response: new Picture(engine, "response") };
    const csv = (name: "orbit" | "response") => element("p", { class: "buttons screen-only" }, button(text.parts.saveData, () => void this.#saveCsv(name)));
    this.#orbit = new Finding(words.orbit, this.#pictures.orbit.element, csv("orbit"));
    this.#response = new Finding(words.responseTitle, this.#pictures.response.element, csv("response"));
    this.elements = [this.#orbit.element, this.#response.element];
  }

  /** The orbit near the start, or to which it leads. */
  async find(command: Command, signal: AbortSignal): Promise<void> {
    const { answer, value } = await read<Orbit>(this.#engine, command, signal);
    if (signal.aborted) return;
    if (value === undefined) return this.#say(this.#orbit, this.#pictures.orbit, answer, []);
    this.#asked = { ...this.#asked, orbit: command };
    this.#orbit.show(element("p", {}, said(value)));
    await this.#pictures.orbit.draw(command, signal);
  }

  /** The answers over a parameter, if one is given; the same ones are not asked for again. */
  async follow(command: Command | undefined, signal: AbortSignal): Promise<void> {
    const key = JSON.stringify(command ?? "");
    if (key === this.#followed) return;
    if (command === undefined) {
      this.#pictures.response.clear();
      this.#followed = key;
      return this.#response.show(element("p", { class: "quiet" }, words.noResponse));
    }
    const { answer, value } = await read<Response>(this.#engine, command, signal);
    if (!isWanted(signal)) return;
    if (value === undefined) return signal.aborted ? undefined : this.#say(this.#response, this.#pictures.response, answer, ["response"]);
    this.#asked = { ...this.#asked, response: command };
    const { parameter, jumps } = value;
    const said = jumps.map((jump) => words.jump(parameter, digits(jump.parameter), jump.sweep, digits(jump.from, 4), jump.to.map((to) => digits(to, 4)).join(", ")));
    this.#response.show(...(said.length > 0 ? said : [words.noJumps]).map((sentence) => element("p", {}, sentence)));
    if (signal.aborted) return;
    const drawn = await this.#pictures.response.draw(command, signal);
    if (drawn.status === 0) this.#followed = key;
  }

  clear(): void {
    for (const [finding, picture] of [[this.#orbit, this.#pictures.orbit], [this.#response, this.#pictures.response]] as const) {
      finding.show();
      picture.clear();
    }
    this.#followed = "";
  }

  /** A question without an answer says why; one that is not understood is wrong in its field. */
  #say(finding: Finding, picture: Picture, answer: Answer, keys: readonly string[]): void {
    picture.clear();
    const why = answer.status === 2 && keys.length > 0 ? this.#form.blame(answer, keys) : reason(answer);
    if (answer.status === 2 && keys.length > 0) finding.fail(why);
    else finding.show(element("p", { class: "quiet" }, why));
  }

  async #saveCsv(name: "orbit" | "response"): Promise<void> {
    const command = this.#asked[name];
    if (command !== undefined) save(`${name}.csv`, (await ask(this.#engine, extended(command, { csv: true }))).output, "text/csv");
  }
}

function said({ period_s, stability, multipliers }: Orbit): string {
  const found = multipliers.filter(([, imaginary]) => imaginary >= 0).map(multiplier);
  const sentences = [words.period(digits(period_s, 9)), words.stability[stability ?? ""] ?? "", found.length > 0 ? words.multipliers(found.join(", ")) : ""];
  return sentences.filter((sentence) => sentence !== "").join(" ");
}

function multiplier([real, imaginary]: readonly [number, number]): string {
  return imaginary === 0 ? digits(real) : words.multiplier(digits(real), digits(imaginary));
}
