// One value that the reader enters: its label, its input, a hint, and an error message.

import { element, identifier } from "./element.ts";
import { isBare, unitName, withoutUnit, withUnit } from "./units.ts";

/** A field of a form. */
export interface Field {
  /** The key in the address. */
  readonly key: string;
  /** The name in the command's errors, such as `--order` or `OSCILLATOR|EQUATION`. */
  readonly option: string | undefined;
  readonly label: string;
  readonly element: HTMLElement;
  readonly initial: string;
  /** `true` if numbers are angles, in the unit that the reader has chosen. */
  readonly isAngle: boolean;
  /** The value as it stands in the field. */
  value: string;
  /** The value, with the unit shown in the field if it was entered without one. */
  readonly measured: string;
  /** Sets the unit of bare numbers; the value entered keeps its meaning. */
  measure(unit: string): void;
  /** Shows what is wrong with the value; an empty reason clears the message. */
  refuse(reason: string): void;
  /** Calls back when the reader has changed the value. */
  onChange(changed: () => void): void;
}

export interface FieldWords {
  readonly label: string;
  /** The values that are allowed, with an example. */
  readonly hint?: string;
  /** The same, shown when the pointer rests on the field. */
  readonly title?: string;
}

interface Description {
  readonly key: string;
  readonly option?: string;
  readonly words: FieldWords;
  readonly initial?: string;
  /** The unit of bare numbers: `angle` is the unit that the reader has chosen for angles. */
  readonly unit?: string;
  /** `true` to leave out the unit of a number that is in the unit of the field. */
  readonly isShort?: boolean;
}

type Control = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;

/** A line of text; `suggestions` are offered while it is typed. */
export function textField(description: Description, suggestions: readonly string[] = []): Field {
  const input = element("input", { type: "text", autocomplete: "off", spellcheck: "false", autocapitalize: "off" });
  const list = element("datalist", { id: identifier() }, ...suggestions.map((value) => element("option", { value })));
  if (suggestions.length > 0) input.setAttribute("list", list.id);
  return controlled(description, input, "input", suggestions.length > 0 ? [list] : []);
}

/** The unit of bare numbers, shown within the field unless the value has units. */
class ShownUnit {
  readonly element = element("span", { class: "unit", id: identifier() });
  readonly #control: Control;
  readonly #isShort: boolean;
  #unit = "";

  constructor(control: Control, isShort: boolean) {
    [this.#control, this.#isShort] = [control, isShort];
    control.addEventListener("input", () => this.show());
  }

  get measured(): string {
    const entry = this.#control.value.trim();
    // A short number may have a decimal comma; elsewhere commas separate.
    return withUnit(this.#isShort ? entry.replace(/^([+\u2212-]?\d+),(\d+)/, "$1.$2") : entry, this.#unit);
  }

  set(unit: string): void {
    if (unit !== this.#unit && unit !== "") this.#control.value = this.measured;
    this.#unit = unit;
    this.put(this.#control.value);
  }

  /** Shows an entry; in fields of short numbers, one in the unit of the field is bare. */
  put(entry: string): void {
    this.#control.value = this.#isShort ? withoutUnit(entry, this.#unit) : entry;
    this.show();
  }

  show(): void {
    const entry = this.#control.value.trim();
    this.element.textContent = entry === "" || isBare(entry) ? unitName(this.#unit) : "";
  }
}

/** One of several values, each with a name. */
export function choiceField(description: Description, choices: readonly (readonly [value: string, name: string])[]): Field {
  const select = element("select", {}, ...choices.map(([value, name]) => element("option", { value }, name)));
  return controlled(description, select, "change");
}

/** Yes or no: `yes` in the address, or nothing. */
export function tickField(description: Description): Field {
  const input = element("input", { type: "checkbox" });
  const { words, key, initial = "" } = description;
  const error = element("p", { class: "error", id: identifier(), hidden: true });
  return {
    key,
    option: description.option,
    label: words.label,
    initial,
    isAngle: false,
    element: element("div", { class: "field tick" }, element("label", {}, input, ` ${words.label}`), hint(words, identifier()), error),
    get value() {
      return input.checked ? "yes" : "";
    },
    set value(value) {
      input.checked = value !== "";
    },
    get measured() {
      return this.value;
    },
    measure: () => {},
    refuse: (reason) => say(error, input, reason),
    onChange: (changed) => input.addEventListener("change", changed),
  };
}

function controlled(description: Description, control: Control, event: string, beside: Node[] = []): Field {
  const { key, option, words, initial = "" } = description;
  control.id = identifier();
  control.name = key;
  if (words.title !== undefined) control.title = words.title;
  control.value = initial;
  const described = identifier();
  const error = element("p", { class: "error", id: identifier(), hidden: true });
  const unit = new ShownUnit(control, description.isShort === true);
  control.setAttribute("aria-describedby", `${unit.element.id} ${described} ${error.id}`);
  const isAngle = description.unit === "angle";
  if (!isAngle) unit.set(description.unit ?? "");
  const entry = description.unit === undefined ? control : element("div", { class: "entry" }, control, unit.element);
  return {
    key,
    option,
    label: words.label,
    initial,
    isAngle,
    element: element("div", { class: "field" }, element("label", { for: control.id }, words.label), entry, ...beside, hint(words, described), error),
    get value() {
      return control.value.trim();
    },
    set value(value) {
      unit.put(value);
    },
    get measured() {
      return unit.measured;
    },
    measure: (its) => unit.set(its),
    refuse: (reason) => say(error, control, reason),
    onChange: (changed) => control.addEventListener(event, changed),
  };
}

function hint(words: FieldWords, id: string): HTMLElement {
  return element("p", { class: "hint", id, hidden: words.hint === undefined }, words.hint ?? "");
}

function say(error: HTMLElement, control: Control, reason: string): void {
  error.textContent = reason;
  error.hidden = reason === "";
  if (reason === "") control.removeAttribute("aria-invalid");
  else control.setAttribute("aria-invalid", "true");
}
