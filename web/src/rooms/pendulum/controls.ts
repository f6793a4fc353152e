// The settings of the room: initial state, pendulum, forces, ghosts, units.

import type { Address } from "../../address.ts";
import { button, element } from "../../parts/element.ts";
import { choiceField, type Field, textField, tickField } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { unitSwitch } from "../../parts/unit_switch.ts";
import { text } from "../../texts/en.ts";
import { APPROXIMATIONS } from "./ghosts.ts";

const words = text.pendulum.fields;

const START = { angle: "150deg", velocity: "0", length: "1m", gravity: "9.80665m/s^2", damping: "0", drive: "0", driveFrequency: "2/3" } as const;

export class Controls {
  readonly elements: readonly HTMLElement[];
  readonly form: Form;
  readonly slider = element("input", { type: "range", min: "0", max: "180", step: "0.1", "aria-label": words.slider });
  readonly #formula: Field;
  readonly #fields = new Map<string, Field>();
  readonly #planet = choiceField({ key: "planet", words: words.planet }, text.pendulum.planets.map(([value = "", name = ""]) => [value, name] as const));
  /** The side of the initial angle, which the slider keeps: it sets the distance from the hanging position. */
  #side = 1;

  constructor(address: Address, changed: () => void, formulasWanted: () => void) {
    const line = (key: keyof typeof START, option: string, unit?: string) => textField({ key, option, words: words[key], initial: START[key], ...(unit !== undefined && { unit }) });
    const chosen = address.get("formula") ?? "";
    this.#formula = choiceField({ key: "formula", words: words.formula }, [["", words.noFormula], ...(chosen === "" ? [] : [[chosen, chosen] as const])]);
    const fields = [
      line("angle", "<ANGLE>", "angle"),
      line("velocity", "--velocity", "rad/s"),
      line("length", "--length", "m"),
      line("gravity", "--gravity", "m/s^2"),
      line("damping", "c"),
      line("drive", "A"),
      line("driveFrequency", "omega"),
      ...APPROXIMATIONS.map((key) => tickField({ key, words: { label: text.pendulum.ghosts[key] ?? key } })),
      this.#formula,
      unitSwitch(),
    ];
    for (const field of fields) this.#fields.set(field.key, field);
    this.form = new Form(address, fields, changed);
    this.#listen(changed, formulasWanted);
    const start = this.form.part(words.start, ["angle", "velocity", "length", "gravity"]);
    start.append(this.#planet.element);
    const forces = this.form.part(words.forces, ["damping", "drive", "driveFrequency"], { folded: true });
    this.elements = [
      this.#presets(changed),
      start,
      element("div", {}, this.form.part(words.ghosts, [...APPROXIMATIONS, "formula"]), forces, this.#field("unit").element),
    ];
  }

  /** Shows the angle of release, in degrees within [−180, 180], and its description, on the slider. */
  slide(degrees: number, words: string): void {
    if (degrees !== 0) this.#side = Math.sign(degrees);
    this.slider.value = String(Math.abs(degrees));
    this.slider.setAttribute("aria-valuetext", words);
  }

  /** Selects the planet with this gravity in m/s², if there is one. */
  name(gravity: number | undefined, read: (entry: string) => number | undefined): void {
    this.#planet.value = text.pendulum.planets.find(([value = ""]) => value !== "" && read(value) === gravity)?.[0] ?? "";
  }

  refuse(key: string, reason: string): void {
    this.#field(key).refuse(reason);
  }

  /** The formulas that can be chosen, by key and name. */
  offer(formulas: readonly (readonly [string, string])[]): void {
    const select = this.#formula.element.querySelector("select");
    const chosen = this.#formula.value;
    select?.replaceChildren(...[["", words.noFormula] as const, ...formulas].map(([value, name]) => element("option", { value }, name)));
    this.#formula.value = chosen;
  }

  #field(key: string): Field {
    const field = this.#fields.get(key);
    if (field === undefined) throw new Error(`no field ${key}`);
    return field;
  }

  #listen(changed: () => void, formulasWanted: () => void): void {
    this.#planet.onChange(() => {
      if (this.#planet.value !== "") this.form.put("gravity", this.#planet.value);
      changed();
    });
    this.slider.addEventListener("input", () => {
      this.form.put("angle", `${this.#side * Number(this.slider.value)}deg`);
      changed();
    });
    this.#formula.element.addEventListener("focusin", formulasWanted, { once: true });
  }

  #presets(changed: () => void): HTMLElement {
    const buttons = text.pendulum.presets.map((preset) =>
      button(preset.name, () => {
        const { name: _, ...its } = preset;
        for (const [key, value] of Object.entries({ ...START, ...its })) this.form.put(key, value);
        changed();
      }),
    );
    return element("fieldset", { class: "presets" }, element("legend", {}, words.presets), ...buttons);
  }
}
