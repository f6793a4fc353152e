// The fields of a room: their values are kept in the address, and the command's errors are shown next to the fields.

import type { Address } from "../address.ts";
import type { Answer } from "../engine/engine.ts";
import { element } from "./element.ts";
import type { Field } from "./field.ts";
import { withoutKeys } from "./in_words.ts";
import { explained, reason } from "./marks.ts";
import { labels, plain } from "./plain.ts";
import { UNIT } from "./unit_switch.ts";

/** Longest pause between two keystrokes before the value is used, in milliseconds. */
const PAUSE = 300;

/** The width from which fields are next to the results, as in parts.css. */
export const BESIDE = "(min-width: 60rem)";

/** All fields of a room, in the order in which they are shown. */
export class Form {
  readonly #fields = new Map<string, Field>();
  readonly #address: Address;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The fields of angles whose variable is not an angle at present. */
  #plain: readonly string[] = [];

  constructor(address: Address, fields: readonly Field[], changed: () => void) {
    this.#address = address;
    for (const field of fields) {
      this.#fields.set(field.key, field);
      field.value = address.get(field.key) ?? field.initial;
      field.onChange(() => {
        if (field.key === UNIT) this.#measure();
        this.keep();
        clearTimeout(this.#timer);
        this.#timer = setTimeout(changed, PAUSE);
      });
    }
    this.#measure();
  }

  /** The value entered, with the unit shown in the field if it has none. */
  value(key: string): string {
    return this.#field(key).measured;
  }

  /** The same, but `undefined` if it is the initial value. */
  chosen(key: string): string | undefined {
    const field = this.#field(key);
    return field.measured === field.initial ? undefined : field.measured;
  }

  /** Sets the fields of angles that hold plain numbers, because the variable is not an angle. */
  plain(keys: readonly string[]): void {
    this.#plain = keys;
    this.#measure();
  }

  /** Enters a value as the reader would, without running a query; a folded field is shown if its value is not the initial one. */
  put(key: string, value: string): void {
    const field = this.#field(key);
    field.value = value;
    if (field.measured !== field.initial) field.element.closest("details.folded")?.setAttribute("open", "");
    this.keep();
  }

  /** Puts the values into the address. */
  keep(): void {
    const all = [...this.#fields.values()];
    this.#address.put(Object.fromEntries(all.map(({ key, measured, initial }) => [key, measured === initial ? undefined : measured])));
  }

  /** The fields of these keys, one below the other. They are folded if they are rarely needed or the page is narrow, so that results are visible
      without scrolling past all fields. */
  part(title: string, keys: readonly string[], attributes: { open?: boolean; folded?: boolean } = {}): HTMLElement {
    const fields = keys.map((key) => this.#field(key).element);
    const isWanted = attributes.folded === true ? keys.some((key) => this.#field(key).measured !== this.#field(key).initial) : matchMedia(BESIDE).matches;
    const open = attributes.open === true || isWanted;
    return element("details", { class: attributes.folded === true ? "fields folded" : "fields", open }, element("summary", {}, title), ...fields);
  }

  /** Clears all error messages. */
  clear(): void {
    for (const field of this.#fields.values()) field.refuse("");
  }

  /** Shows the failure next to the field that it is about, of these or of all; returns the reason if it is about none. */
  blame(answer: Answer, keys: readonly string[] = [...this.#fields.keys()]): string {
    const { error } = answer;
    const field = keys.map((key) => this.#field(key)).find(({ option }) => option !== undefined && error.parameters.includes(option));
    if (field === undefined) return reason(error);
    field.refuse(withoutKeys(plain(explained(error), labels(this.#fields.values()))));
    field.element.closest("details")?.setAttribute("open", "");
    return "";
  }

  /** Sets the unit of bare numbers to that of the unit switch, or to degrees if there is none. */
  #measure(): void {
    const unit = this.#fields.get(UNIT)?.value ?? "deg";
    for (const field of this.#fields.values()) if (field.isAngle) field.measure(this.#plain.includes(field.key) ? "" : unit);
  }

  #field(key: string): Field {
    const field = this.#fields.get(key);
    if (field === undefined) throw new Error(`no field ${key}`);
    return field;
  }
}
