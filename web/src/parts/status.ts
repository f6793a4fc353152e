// A line that shows whether a query is running and its progress, with a button to stop it.

import { text } from "../texts/en.ts";
import { button, element } from "./element.ts";

/** Time before the line appears, in milliseconds: fast queries need none. */
const DELAY = 250;

/** The line, which screen readers announce. */
export class Status {
  readonly element: HTMLElement;
  readonly #words = element("span", { role: "status" });
  readonly #stop: HTMLButtonElement;

  #isStopped = false;

  constructor(stopped: () => void) {
    this.#stop = button(text.parts.stop, () => {
      this.#isStopped = true;
      stopped();
    });
    this.#stop.hidden = true;
    this.element = element("p", { class: "status screen-only" }, this.#words, " ", this.#stop);
  }

  /** Shows that work is running, after a delay, until it has ended. */
  async during<T>(work: Promise<T>): Promise<T> {
    const shown = setTimeout(() => {
      this.say(text.parts.computing);
      this.#stop.hidden = false;
    }, DELAY);
    this.#busy(true);
    this.#isStopped = false;
    try {
      return await work;
    } finally {
      clearTimeout(shown);
      this.#busy(false);
      this.#stop.hidden = true;
      this.say(this.#isStopped ? text.parts.stopped : "");
    }
  }

  /** Shows the progress of the running query, if it reports any. */
  progress(howFar: string | undefined): void {
    if (howFar !== undefined) this.say(`${text.parts.computing} ${howFar}`);
  }

  // Results that are still changing are announced when they are complete.
  #busy(is: boolean): void {
    this.element.parentElement?.setAttribute("aria-busy", String(is));
  }

  say(words: string): void {
    if (this.#words.textContent !== words) this.#words.textContent = words;
  }
}
