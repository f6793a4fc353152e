// Sliders for the drive and the damping of a driven pendulum, next to the pendulum that swings.

import { element, identifier } from "../../parts/element.ts";
import type { Form } from "../../parts/form.ts";
import { short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import { nameOf } from "./questions.ts";

const words = text.chaos.sliders;
/** Time without a further movement after which the motion begins anew, in milliseconds. */
const PAUSE = 150;

interface Parameter {
  readonly name: keyof typeof words.names;
  readonly unit: string;
  readonly range: readonly [from: number, to: number, step: number];
  /** The value of the system if none is set. */
  readonly usual: number;
}

const TORQUE: readonly Parameter[] = [
  { name: "A", unit: "1/s²", range: [0, 2, 0.005], usual: 0 },
  { name: "omega", unit: "rad/s", range: [0.1, 2, 0.005], usual: 2 / 3 },
  { name: "c", unit: "1/s", range: [0, 1, 0.01], usual: 0 },
];
const PIVOT: readonly Parameter[] = [
  { name: "a", unit: "", range: [0, 0.6, 0.002], usual: 0 },
  { name: "omega", unit: "rad/s", range: [0.5, 30, 0.1], usual: 2 },
  { name: "c", unit: "1/s", range: [0, 1, 0.01], usual: 0 },
];
const SYSTEMS: Readonly<Record<string, readonly Parameter[]>> = {
  driven_pendulum: TORQUE, driven: TORQUE, forced_pendulum: TORQUE, vertically_driven_pendulum: PIVOT, kapitza: PIVOT, kapitza_pendulum: PIVOT, parametric_pendulum: PIVOT,
};

export class Sliders {
  readonly element = element("div", { class: "sliders", role: "group", "aria-label": words.group, hidden: true });
  readonly #form: Form;
  readonly #changed: () => void;
  #shown: readonly Parameter[] = [];
  #show: (() => void)[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(form: Form, changed: () => void) {
    [this.#form, this.#changed] = [form, changed];
  }

  /** Shows the sliders of the system, with the values in the fields. */
  show(): void {
    const parameters = SYSTEMS[this.#form.value("system")] ?? [];
    if (parameters !== this.#shown) {
      [this.#shown, this.#show] = [parameters, []];
      this.element.replaceChildren(...parameters.map((parameter) => this.#slider(parameter)));
    }
    this.element.hidden = parameters.length === 0;
    for (const show of this.#show) show();
  }

  #slider({ name, unit, range: [from, to, step], usual }: Parameter): HTMLElement {
    const id = identifier();
    const input = element("input", { type: "range", id, min: String(from), max: String(to), step: String(step) });
    const readout = element("output", { for: id });
    const said = (value: number) => {
      readout.textContent = words.value(name, short(value, 4), unit);
      input.setAttribute("aria-valuetext", readout.textContent);
    };
    this.#show.push(() => {
      const value = this.#value(name) ?? usual;
      if (!Number.isFinite(value)) return;
      input.value = String(value);
      said(value);
    });
    input.addEventListener("input", () => {
      said(Number(input.value));
      this.#put(name, input.value);
      clearTimeout(this.#timer);
      this.#timer = setTimeout(this.#changed, PAUSE);
    });
    return element("div", {}, element("label", { for: id }, words.names[name]), input, readout);
  }

  #value(name: string): number | undefined {
    if (nameOf(this.#form.value("over")) === name && this.#form.value("value") !== "") return number(this.#form.value("value"));
    const set = this.#set().find((it) => nameOf(it) === name);
    return set === undefined ? undefined : number(set.slice(set.indexOf("=") + 1));
  }

  // The parameter of the diagram has a field of its own.
  #put(name: string, value: string): void {
    if (nameOf(this.#form.value("over")) === name) return this.#form.put("value", value);
    this.#form.put("set", [...this.#set().filter((it) => nameOf(it) !== name), `${name}=${value}`].join(","));
  }

  #set(): string[] {
    return this.#form.value("set").split(",").filter((it) => it.trim() !== "");
  }
}

/** A number or a fraction; NaN for other formulas. */
function number(written: string): number {
  const [numerator = NaN, denominator = 1] = written.split("/").map(Number);
  return numerator / denominator;
}
