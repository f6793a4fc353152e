// Tables that scroll separately if the page is narrow.

import { element } from "./element.ts";
import { scrolling } from "./scrolling.ts";

export interface Column {
  readonly title: string;
  /** `true` for numbers, which are aligned to the right. */
  readonly isNumber?: boolean;
}

/** A table with a caption; the first cell of a row is its heading. */
export function table(caption: string, columns: readonly Column[], rows: readonly (readonly (string | Node)[])[]): HTMLElement {
  const kind = (place: number) => (columns[place]?.isNumber === true ? { class: "number" } : {});
  const head = columns.map(({ title }, place) => element("th", { scope: "col", ...kind(place) }, title));
  const lines = rows.map((row) =>
    element("tr", {}, ...row.map((cell, place) => (place === 0 ? element("th", { scope: "row", ...kind(0) }, cell) : element("td", kind(place), cell)))),
  );
  const made = element("table", {}, element("caption", {}, caption), element("thead", {}, element("tr", {}, ...head)), element("tbody", {}, ...lines));
  const place = element("div", { class: "scroll", role: "region", "aria-label": caption }, made);
  scrolling(place);
  return place;
}
