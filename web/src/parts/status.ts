// A line that says whether a question is being answered, how far it is, and lets it be stopped.

import { text } from "../texts/en.ts";
import { button, element } from "./element.ts";

/** Quick answers need no line, in milliseconds. */
const DELAY = 250;

/** The line; screen readers hear what it says. */
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

  /** Shows that something runs, from a moment on, until the work has ended. */
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

  /** How far the question is that runs, where it says so. */
  progress(howFar: string | undefined): void {
    if (howFar !== undefined) this.say(`${text.parts.computing} ${howFar}`);
  }

  // Results that are still changing are read aloud when they are there.
  #busy(is: boolean): void {
    this.element.parentElement?.setAttribute("aria-busy", String(is));
  }

  say(words: string): void {
    if (this.#words.textContent !== words) this.#words.textContent = words;
  }
}
