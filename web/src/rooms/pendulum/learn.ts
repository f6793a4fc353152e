// Short tasks with the bench: something to do, something to see, and the reason on demand.

import { button, element } from "../../parts/element.ts";
import { explainedTerms } from "../../parts/terms.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.learn;

export class Learn {
  readonly element: HTMLElement;
  readonly #task = element("div", { "aria-live": "polite" });
  readonly #back = button(words.back, () => this.#go(-1));
  readonly #next = button(words.next, () => this.#go(1), { class: "main" });
  #place = 0;

  constructor() {
    this.element = element("div", { class: "card learn", role: "group", "aria-label": words.title }, this.#task, element("p", { class: "buttons" }, this.#back, this.#next));
    this.#go(0);
  }

  #go(by: number): void {
    this.#place += by;
    const task = words.tasks[this.#place];
    if (task === undefined) return;
    const reason = element("details", {}, element("summary", {}, words.reason), element("p", {}, ...explainedTerms(task.reason)));
    this.#task.replaceChildren(element("h2", {}, words.count(this.#place + 1, words.tasks.length)), element("p", {}, ...explainedTerms(task.act)), reason);
    this.#back.disabled = this.#place === 0;
    this.#next.disabled = this.#place === words.tasks.length - 1;
  }
}
