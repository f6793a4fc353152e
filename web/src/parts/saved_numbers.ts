// A button that saves the numbers of a result as CSV, shown only if there are some.

import type { Engine } from "../engine/engine.ts";
import { text } from "../texts/en.ts";
import { ask, type Command, extended } from "./command.ts";
import { button, element } from "./element.ts";
import { saveAnswer } from "./save.ts";

export class SavedNumbers {
  readonly element: HTMLElement;
  readonly #engine: Engine;
  readonly #name: string;
  readonly #failure = element("span", { class: "error", role: "alert", hidden: true });
  #command: Command | undefined;

  /** `name` is that of the saved file. */
  constructor(engine: Engine, name: string) {
    [this.#engine, this.#name] = [engine, `${name}.csv`];
    this.element = element("p", { class: "buttons screen-only", hidden: true }, button(text.parts.saveData, () => void this.#save()), this.#failure);
  }

  /** Sets the query whose numbers can be saved; without one there is no button. */
  offer(command: Command | undefined): void {
    this.#command = command;
    this.element.hidden = command === undefined;
    this.#fail("");
  }

  async #save(): Promise<void> {
    if (this.#command === undefined) return;
    this.#fail(saveAnswer(this.#name, await ask(this.#engine, extended(this.#command, { csv: true })), "text/csv"));
  }

  #fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
  }
}
