// The value chosen in a diagram belongs to the parameter of the range: it is kept when the range is removed or gets another parameter.

import type { Form } from "../../parts/form.ts";
import { nameOf } from "./questions.ts";

export class ValueKeeper {
  readonly #form: Form;
  #name: string;

  constructor(form: Form) {
    this.#form = form;
    this.#name = this.#now();
  }

  /** Forgets the parameter after the fields were filled: the value belongs to the new range. */
  forget(): void {
    this.#name = this.#now();
  }

  /** If the range has another parameter than before, moves the value of the former one to the values of parameters, and takes that of the new one from there. */
  keep(): void {
    const [before, now] = [this.#name, this.#now()];
    if (before === now) return;
    this.#name = now;
    const value = this.#form.value("value");
    const set = this.#form.value("set").split(",").filter((it) => it.trim() !== "");
    const others = before === "" || value === "" ? set : [...set, `${before}=${value}`];
    const known = now === "" ? undefined : others.find((it) => nameOf(it) === now);
    this.#form.put("set", others.filter((it) => it !== known).join(","));
    if (known !== undefined || before !== "") this.#form.put("value", known === undefined ? "" : known.slice(known.indexOf("=") + 1).trim());
  }

  /** The name of the parameter of the range; empty without `=`. */
  #now(): string {
    const over = this.#form.value("over");
    return over.includes("=") ? nameOf(over) : "";
  }
}
