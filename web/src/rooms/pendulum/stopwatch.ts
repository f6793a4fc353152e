// A stopwatch that is started and stopped by hand. It runs in the time of the pendulum.

import { button, element } from "../../parts/element.ts";
import { textField } from "../../parts/field.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.instruments.stopwatch;

export class Stopwatch {
  readonly element: HTMLElement;
  readonly #reading = element("output", { class: "display" }, "0.00 s");
  readonly #run = button(words.start, () => this.#toggle(), { class: "main" });
  readonly #swings = textField({ key: "swings", words: { label: text.pendulum.instruments.gate.swings }, initial: "10" });
  #elapsed = 0;
  #isRunning = false;
  #last: number | undefined;

  /** `into` is called with the time of a number of swings, as displayed, for the table. */
  constructor(into: (swings: number, seconds: string) => void) {
    const put = button(text.pendulum.instruments.gate.into, () => {
      const swings = Number(this.#swings.value);
      const isRight = Number.isInteger(swings) && swings > 0;
      this.#swings.refuse(isRight ? "" : words.wrongSwings);
      if (isRight && this.#elapsed > 0) into(swings, this.#elapsed.toFixed(2));
    });
    const buttons = element("p", { class: "buttons" }, this.#run, button(words.zero, () => this.#zero()), put);
    this.element = element("div", { class: "card", role: "group", "aria-label": words.title }, element("h2", {}, words.title), this.#reading, this.#swings.element, buttons);
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
