// The value that is chosen in a diagram belongs to the parameter of the range: it stays with it when the range is taken away or gets another one.

import type { Form } from "../../parts/form.ts";
import { nameOf } from "./questions.ts";

export class ValueKeeper {
  readonly #form: Form;
  #name: string;

  constructor(form: Form) {
    this.#form = form;
    this.#name = this.#now();
  }

  /** The fields were filled anew: the value belongs to the range beside it. */
  forget(): void {
    this.#name = this.#now();
  }

  /** Where the range has another parameter than before, puts the value of that before among the values of parameters, and takes from there that of the new one. */
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

  /** The parameter of the range, once it is one. */
  #now(): string {
    const over = this.#form.value("over");
    return over.includes("=") ? nameOf(over) : "";
  }
}
