// The numbers of a picture as a table for readers who do not see it, computed when the table is opened.

import { text } from "../texts/en.ts";
import { element } from "./element.ts";
import { digits } from "./numbers.ts";
import { table } from "./table.ts";

/** Maximum number of rows; all numbers are in the saved file. */
const MOST = 100;

export class NumbersTable {
  readonly element = element("details", { hidden: true });
  readonly #place = element("div");

  /** `load` returns the numbers as CSV with a heading. */
  constructor(load: () => Promise<string>) {
    this.element.append(element("summary", {}, text.parts.numbers), this.#place);
    this.element.addEventListener("toggle", async () => {
      if (this.element.open && this.#place.childElementCount === 0) this.#place.replaceChildren(tabled(await load()));
    });
  }

  /** Offers the table of new numbers, or none. */
  offer(isThere: boolean): void {
    this.element.hidden = !isThere;
    this.element.open = false;
    this.#place.replaceChildren();
  }
}

function tabled(csv: string): HTMLElement {
  const [head = "", ...lines] = csv.trimEnd().split("\n");
  const columns = head.split(",").map((title) => ({ title: title.replaceAll("_", " "), isNumber: true }));
  const rows = lines.slice(0, MOST).map((line) => line.split(",").map((cell) => (cell !== "" && Number.isFinite(Number(cell)) ? digits(Number(cell), 5) : cell)));
  return table(text.parts.rows(Math.min(MOST, lines.length), lines.length), columns, rows);
}
