// The selection of formulas: a tick for each, in the order of the catalogue.

import type { Address } from "../../address.ts";
import { button, element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";
import type { Formula } from "./catalogue.ts";

/** The formulas in the first figure of Black and Vel. */
const USUAL = ["bernoulli", "molina", "kidd_fogg", "butikov", "power_series_3", "denman", "black_vel_2", "black_vel_3"];

export class Selection {
  readonly element: HTMLDetailsElement;
  readonly #address: Address;
  readonly #title = element("summary");
  readonly #boxes = new Map<string, HTMLInputElement>();
  readonly #list = element("div", { class: "choices" });
  readonly #changed: () => void;

  constructor(address: Address, changed: () => void) {
    [this.#address, this.#changed] = [address, changed];
    const words = text.formulas;
    const set = (label: string, keys: (key: string) => boolean) => button(label, () => this.#set(keys));
    const buttons = element("p", { class: "buttons" }, set(words.usual, (key) => USUAL.includes(key)), set(words.all, () => true), set(words.none, () => false));
    this.element = element("details", { class: "fields", open: innerWidth >= 960 }, this.#title, buttons, this.#list);
  }

  /** Offers the formulas of the catalogue. */
  offer(formulas: readonly Formula[]): void {
    const asked = this.#asked();
    for (const { key, name, year } of formulas) {
      const box = element("input", { type: "checkbox", value: key });
      box.checked = asked.includes(key);
      box.addEventListener("change", () => this.#keep());
      this.#boxes.set(key, box);
      this.#list.append(element("label", {}, box, ` ${name}${year === null ? "" : ` (${year})`}`));
    }
    this.#count();
  }

  /** The keys of the chosen formulas. */
  get keys(): string[] {
    if (this.#boxes.size === 0) return this.#asked();
    return [...this.#boxes.values()].filter(({ checked }) => checked).map(({ value }) => value);
  }

  #asked(): string[] {
    return this.#address.get("formulas")?.split(",").filter((key) => key !== "") ?? USUAL;
  }

  #set(wanted: (key: string) => boolean): void {
    for (const [key, box] of this.#boxes) box.checked = wanted(key);
    this.#keep();
  }

  #keep(): void {
    const keys = this.keys.join(",");
    const usual = [...this.#boxes.keys()].filter((key) => USUAL.includes(key)).join(",");
    this.#address.put({ formulas: keys === usual ? undefined : keys });
    this.#count();
    this.#changed();
  }

  #count(): void {
    this.#title.textContent = text.formulas.chosen(this.keys.length);
  }
}
