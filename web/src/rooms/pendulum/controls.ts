// The settings of the room: initial state, pendulum, forces, ghosts, units.

import type { Address } from "../../address.ts";
import { button, element } from "../../parts/element.ts";
import { choiceField, type Field, textField, tickField } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { plain } from "../../parts/plain.ts";
import { UNIT, unitSwitch } from "../../parts/unit_switch.ts";
import { converted } from "../../parts/units.ts";
import { text } from "../../texts/en.ts";
import { APPROXIMATIONS } from "./ghosts.ts";
import { QUANTITIES } from "./graphs.ts";
import { newSecret, type Secret, secretOf } from "./secret.ts";

const words = text.pendulum.fields;
/** The choice of a planet whose gravity is hidden. */
const MYSTERY = "mystery";

const START = { angle: "150deg", velocity: "0", length: "1m", gravity: "9.80665m/s^2", damping: "0", drag: "0", dry: "0", drive: "0", driveFrequency: "2/3", mass: "", angle2: "150deg", length2: "0.5m", gravity2: "9.80665m/s^2", mass2: "" } as const;

/** Ticks of the bench; the first two are set at first. */
const TICKS = ["trace", "bars", "arrows", "stopwatch", "gate", "ruler", "protractor", "hide", "second"] as const;
/** The kinds of friction by their fields, with the largest value of the slider. */
const FRICTION = { damping: 1, drag: 1, dry: 2 } as const;
type Friction = keyof typeof FRICTION;

export class Controls {
  /** What stands next to the stage. */
  readonly panel: readonly HTMLElement[];
  /** What is needed rarely. */
  readonly further: readonly HTMLElement[];
  /** The axes of the free graph. */
  readonly axes: readonly HTMLElement[];
  readonly form: Form;
  readonly #slider = element("input", { type: "range", min: "0", max: "180", step: "0.1", "aria-label": words.slider });
  readonly #lengthSlider = element("input", { type: "range", min: "0.1", max: "2", step: "0.01", "aria-label": words.lengthSlider });
  readonly #formula: Field;
  readonly #fields = new Map<string, Field>();
  readonly #planet = choiceField({ key: "planet", words: words.planet }, text.pendulum.planets.map(([value = "", name = ""]) => [value, name] as const));
  readonly #friction = choiceField({ key: "friction", words: { label: words.friction } }, words.frictions.map(([value = "", name = ""]) => [value, name] as const));
  readonly #frictionSlider = element("input", { type: "range", min: "0", max: "1", step: "0.01", "aria-label": words.frictionSlider });
  readonly #reveal = button(words.reveal, () => this.#disclose());
  readonly #changed: () => void;
  /** The side of the initial angle, which the slider keeps: it sets the distance from the hanging position. */
  #side = 1;

  constructor(address: Address, changed: () => void, formulasWanted: () => void) {
    this.#changed = changed;
    const line = (key: keyof typeof START, option: string, unit?: string) => textField({ key, option, words: words[key], initial: START[key], isShort: true, ...(unit !== undefined && { unit }) });
    const axis = (key: "across" | "up", initial: string) => choiceField({ key, words: { label: words[key] }, initial }, QUANTITIES.map((it) => [it, text.pendulum.graphs.free.quantities[it]] as const));
    const chosen = address.get("formula") ?? "";
    this.#formula = choiceField({ key: "formula", words: words.formula }, [["", words.noFormula], ...(chosen === "" ? [] : [[chosen, chosen] as const])]);
    const fields = [
      line("angle", "<ANGLE>", "angle"),
      line("velocity", "--velocity", "rad/s"),
      line("length", "--length", "m"),
      line("gravity", "--gravity", "m/s^2"),
      line("damping", "c"),
      line("drag", "q"),
      line("dry", "f"),
      line("drive", "A"),
      line("driveFrequency", "omega"),
      line("mass", "mass", "kg"),
      line("angle2", "angle2", "angle"),
      line("length2", "length2", "m"),
      line("gravity2", "gravity2", "m/s^2"),
      line("mass2", "mass2", "kg"),
      textField({ key: "secret", words: { label: "" } }),
      ...TICKS.map((key, place) => tickField({ key, words: { label: words[key] }, initial: place < 2 ? "yes" : "" })),
      ...APPROXIMATIONS.map((key) => tickField({ key, words: { label: text.pendulum.ghosts[key] ?? key } })),
      this.#formula,
      choiceField({ key: "view", words: words.view }, words.views.map(([value = "", name = ""]) => [value, name] as const)),
      axis("across", "angle"),
      axis("up", "potential"),
      unitSwitch(),
    ];
    for (const field of fields) this.#fields.set(field.key, field);
    this.form = new Form(address, fields, changed);
    this.#listen(changed, formulasWanted);
    const withSlider = (key: string, below: HTMLElement) => element("div", { class: "quantity" }, this.#field(key).element, below);
    const ticks = (label: string, keys: readonly (typeof TICKS)[number][]) => element("div", { class: "shown", role: "group", "aria-label": label }, ...keys.map((key) => this.#field(key).element));
    const second = this.form.part(words.secondPendulum, ["second", "angle2", "length2", "gravity2", "mass2"], { folded: true });
    const friction = this.form.part(words.frictionAndMass, ["mass"], { folded: true });
    friction.append(this.#friction.element, this.#frictionSlider);
    this.axes = [this.#field("across").element, this.#field("up").element];
    this.panel = [
      withSlider("angle", this.#slider),
      withSlider("length", this.#lengthSlider),
      withSlider("gravity", this.#planet.element),
      element("div", { class: "two" }, this.#field("view").element, this.#field("unit").element),
      ticks(words.shown, ["arrows", "trace", "bars"]),
      ticks(words.instruments, ["gate", "stopwatch", "ruler", "protractor"]),
      friction,
      second,
      element("div", { class: "shown" }, this.#field("hide").element, button(words.mystery, () => this.#hide("pendulum", changed)), this.#reveal),
    ];
    this.further = [
      this.#presets(changed),
      this.form.part(words.ghosts, [...APPROXIMATIONS, "formula"]),
      element("div", {}, this.form.part(words.start, ["velocity"]), this.form.part(words.forces, ["damping", "drag", "dry", "drive", "driveFrequency"], { folded: true })),
    ];
  }

  /** Shows the angle of release, in degrees within [−180, 180], and its description, on the slider. */
  slide(degrees: number, words: string): void {
    if (degrees !== 0) this.#side = Math.sign(degrees);
    this.#slider.value = String(Math.abs(degrees));
    this.#slider.setAttribute("aria-valuetext", words);
  }

  /** Shows the length, in metres, on its slider. */
  slideLength(metres: number): void {
    this.#lengthSlider.value = String(metres);
    this.#lengthSlider.setAttribute("aria-valuetext", `${metres} m`);
  }

  /** What is hidden until it is revealed. */
  get secret(): Secret {
    return secretOf(this.form.value("secret"));
  }

  /** `true` if a number must not be shown: it is hidden itself, or would give away what is. */
  isHidden(key: "period" | "length" | "gravity"): boolean {
    const { gravity, length } = this.secret;
    return key === "period" ? this.form.value("hide") === "yes" || gravity !== undefined || length !== undefined : key === "gravity" ? gravity !== undefined : length !== undefined;
  }

  /** Shows what is hidden, and the friction, on their controls. */
  show(): void {
    const { gravity, length } = this.secret;
    this.#reveal.hidden = gravity === undefined && length === undefined;
    if (gravity !== undefined) this.#planet.value = MYSTERY;
    for (const [key, value] of [["gravity", gravity], ["length", length]] as const) {
      const input = this.#field(key).element.querySelector("input");
      if (input !== null) input.disabled = value !== undefined;
    }
    this.#lengthSlider.disabled = length !== undefined;
    const kind = (Object.keys(FRICTION) as Friction[]).find((key) => !["", "0"].includes(this.form.value(key)));
    if (kind !== undefined) this.#friction.value = kind;
    this.#frictionSlider.disabled = this.#friction.value === "";
    if (kind !== undefined) this.#frictionSlider.value = String(Number(this.form.value(kind)) / FRICTION[kind]);
  }

  #hide(kind: "planet" | "pendulum", changed: () => void): void {
    if (this.secret.gravity !== undefined || this.secret.length !== undefined) this.#disclose();
    this.form.put("secret", newSecret(kind));
    this.form.put(kind === "planet" ? "gravity" : "length", "?");
    changed();
  }

  #disclose(): void {
    const { gravity, length } = this.secret;
    this.form.put("secret", "");
    if (gravity !== undefined) this.form.put("gravity", `${gravity}m/s^2`);
    if (length !== undefined) this.form.put("length", `${length}m`);
    this.#changed();
  }

  /** Sets one kind of friction, and removes the others. */
  #rub(): void {
    const kind = this.#friction.value;
    for (const key of Object.keys(FRICTION) as Friction[]) {
      const value = key === kind ? Number(this.#frictionSlider.value) * FRICTION[key] : 0;
      this.form.put(key, String(Number(value.toFixed(3))));
    }
    this.#changed();
  }

  /** Selects the planet with this gravity in m/s², if there is one. */
  name(gravity: number | undefined, read: (entry: string) => number | undefined): void {
    this.#planet.value = text.pendulum.planets.find(([value = ""]) => value !== "" && value !== MYSTERY && read(value) === gravity)?.[0] ?? "";
  }

  refuse(key: string, reason: string): void {
    this.#field(key).refuse(plain(reason));
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
      if (this.#planet.value === MYSTERY) return this.#hide("planet", changed);
      if (this.secret.gravity !== undefined) this.form.put("secret", "");
      if (this.#planet.value !== "") this.form.put("gravity", this.#planet.value);
      changed();
    });
    this.#slider.addEventListener("input", () => {
      this.form.put("angle", `${this.#side * Number(this.#slider.value)}deg`);
      changed();
    });
    this.#lengthSlider.addEventListener("input", () => {
      this.form.put("length", `${this.#lengthSlider.value}m`);
      changed();
    });
    this.#friction.onChange(() => {
      if (Number(this.#frictionSlider.value) === 0) this.#frictionSlider.value = "0.1";
      this.#rub();
    });
    this.#frictionSlider.addEventListener("input", () => this.#rub());
    const unit = this.#field(UNIT);
    unit.onChange(() => ["angle", "angle2"].forEach((key) => this.form.put(key, converted(this.form.value(key), unit.value))));
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
