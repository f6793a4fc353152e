// The layout of a room: fields on one side, results on the other.

import { element } from "./element.ts";

export function layout(title: string, lead: string, controls: readonly Node[], results: readonly Node[]): HTMLElement[] {
  return [
    element("h1", {}, title),
    element("p", { class: "lead" }, lead),
    element("div", { class: "room" }, element("div", { class: "controls" }, ...controls), element("div", { class: "results" }, ...results)),
  ];
}

/** A part of the results, with a place for the result and for the reason why there is none. */
export class Finding {
  readonly element: HTMLElement;
  readonly #failure = element("p", { class: "error", role: "alert", hidden: true });
  readonly #place = element("div");

  /** The title is `undefined` if the result has a title of its own. */
  constructor(title: string | undefined, ...below: Node[]) {
    const heading = title === undefined ? [] : [element("h2", {}, title)];
    this.element = element("section", {}, ...heading, this.#failure, this.#place, ...below);
  }

  show(...found: (Node | string)[]): void {
    this.fail("");
    this.#place.replaceChildren(...found);
  }

  /** Shows the reason why there is no result, and removes the previous result. */
  fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
    if (reason !== "") this.#place.replaceChildren();
  }
}
