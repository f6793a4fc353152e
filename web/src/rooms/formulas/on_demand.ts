// A part of the results that is computed when the reader opens it; whether it is open is kept in the address.

import type { Address } from "../../address.ts";
import { element } from "../../parts/element.ts";

export class OnDemand {
  readonly element: HTMLDetailsElement;
  readonly place = element("div");
  /** The query whose result is shown. */
  #shown = "";

  constructor(address: Address, key: string, title: string, opened: () => void) {
    this.element = element("details", { class: "asked", open: address.get(key) === "yes" }, element("summary", {}, element("h2", {}, title)), this.place);
    this.element.addEventListener("toggle", () => {
      const { open } = this.element;
      if (open === (address.get(key) === "yes")) return;
      address.put({ [key]: open ? "yes" : undefined });
      if (open) opened();
    });
  }

  /** Shows the result of the query, unless the part is folded or shows it already. */
  async show(query: string, found: () => Promise<Node[] | undefined>): Promise<void> {
    if (!this.element.open || this.#shown === query) return;
    const nodes = await found();
    if (nodes === undefined) return;
    this.#shown = query;
    this.place.replaceChildren(...nodes);
  }
}
