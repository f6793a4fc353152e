// A finding with a field of its own: sentences with a picture, not computed again while the query stays the same.

import type { Answer, Engine } from "../../engine/engine.ts";
import type { Command } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import type { Form } from "../../parts/form.ts";
import { isWanted } from "../../parts/latest.ts";
import { Finding } from "../../parts/layout.ts";
import { Picture } from "../../parts/picture.ts";
import { SavedNumbers } from "../../parts/saved_numbers.ts";
import { text } from "../../texts/en.ts";
import { said } from "./said.ts";

const words = text.chaos;

/** The query, and the sentences about its result. */
export interface Asking<T> {
  readonly title: string;
  /** The name of saved files. */
  readonly name: string;
  /** The fields that may contain the error if the query is invalid. */
  readonly fields: readonly string[];
  readonly said: (answer: T) => readonly (Node | string)[];
}

/** Such a finding, without its type. */
export interface Further {
  readonly element: HTMLElement;
  expect(command: Command | undefined): void;
  find(command: Command | undefined, signal: AbortSignal): Promise<void>;
  clear(): void;
}

export class Asked<T> implements Further {
  readonly element: HTMLElement;
  readonly #form: Form;
  readonly #asking: Asking<T>;
  readonly #picture: Picture;
  readonly #finding: Finding;
  readonly #numbers: SavedNumbers;
  /** The query whose result is shown, complete or partial. */
  #shown: Command | undefined;
  #isWhole = false;

  constructor(engine: Engine, form: Form, asking: Asking<T>) {
    [this.#form, this.#asking] = [form, asking];
    this.#picture = new Picture(engine, asking.name);
    this.#numbers = new SavedNumbers(engine, asking.name);
    this.#finding = new Finding(asking.title, this.#picture.element, this.#numbers.element, this.#numbers.table.element);
    this.element = this.#finding.element;
    this.element.hidden = true;
  }

  /** Shows the place of the result; nothing without a query. */
  expect(command: Command | undefined): void {
    this.element.hidden = command === undefined;
    if (command === undefined) this.clear();
    else if (this.#shown === undefined) this.#finding.show(quiet(words.expected));
  }

  /** Shows the result, or the reason why there is none. */
  async find(command: Command | undefined, signal: AbortSignal): Promise<void> {
    if (command === undefined || (this.#isWhole && same(command, this.#shown))) return;
    const { answer, value } = await this.#picture.read<T>(command, signal);
    if (!isWanted(signal)) return;
    if (value === undefined) return this.#refuse(answer);
    [this.#shown, this.#isWhole] = [command, !signal.aborted];
    this.#numbers.offer(command);
    this.#finding.show(...this.#asking.said(value).map((it) => (typeof it === "string" ? element("p", {}, it) : it)));
  }

  clear(): void {
    this.#forget();
    this.#finding.show();
  }

  /** Shows an invalid query in its field, and otherwise the reason why there is no result. */
  #refuse(answer: Answer): void {
    this.#forget();
    const why = answer.status === 2 ? this.#form.blame(answer, this.#asking.fields) : "";
    if (answer.status === 2) this.#finding.fail(why);
    else this.#finding.show(quiet(said(answer)));
    this.element.hidden = answer.status === 2 && why === "";
  }

  #forget(): void {
    this.#picture.clear();
    [this.#shown, this.#isWhole] = [undefined, false];
    this.#numbers.offer(undefined);
  }
}

function quiet(said: string): HTMLElement {
  return element("p", { class: "quiet" }, said);
}

function same(one: Command, other: Command | undefined): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}
