// A button that saves the numbers of a result as CSV, shown only if there are some.

import { type Answer, type Engine, text as decoded } from "../engine/engine.ts";
import { text } from "../texts/en.ts";
import { ask, type Command, extended } from "./command.ts";
import { button, element } from "./element.ts";
import { NumbersTable } from "./numbers_table.ts";
import { saveAnswer } from "./save.ts";

export class SavedNumbers {
  readonly element: HTMLElement;
  /** The same numbers as a table, for a place of its own. */
  readonly table = new NumbersTable(async () => decoded(await this.#csv()));
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
    this.table.offer(command !== undefined);
    this.#fail("");
  }

  async #save(): Promise<void> {
    if (this.#command !== undefined) this.#fail(saveAnswer(this.#name, await this.#csv(), "text/csv"));
  }

  #csv(): Promise<Answer> {
    return ask(this.#engine, extended(this.#command ?? { question: "" }, { csv: true }));
  }

  #fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
  }
}
