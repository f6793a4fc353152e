// A stopwatch that is started and stopped by hand. It runs in the time of the pendulum.

import { button, element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.instruments.stopwatch;

export class Stopwatch {
  readonly element: HTMLElement;
  readonly #reading = element("output", { class: "display" }, "0.00 s");
  readonly #run = button(words.start, () => this.#toggle(), { class: "main" });
  #elapsed = 0;
  #isRunning = false;
  #last: number | undefined;

  constructor() {
    const buttons = element("p", { class: "buttons" }, this.#run, button(words.zero, () => this.#zero()));
    this.element = element("div", { class: "card", role: "group", "aria-label": words.title }, element("h2", {}, words.title), this.#reading, buttons);
  }

  /** Adds the time since the last call; steps back count nothing. */
  follow(time: number): void {
    if (this.#isRunning && this.#last !== undefined && time > this.#last) {
      this.#elapsed += time - this.#last;
      this.#show();
    }
    this.#last = time;
  }

  #toggle(): void {
    this.#isRunning = !this.#isRunning;
    this.#run.textContent = this.#isRunning ? words.stop : words.start;
  }

  #zero(): void {
    this.#elapsed = 0;
    this.#show();
  }

  #show(): void {
    this.#reading.textContent = `${this.#elapsed.toFixed(2)} s`;
  }
}
