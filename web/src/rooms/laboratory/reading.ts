// The command's interpretation of a file, with its reasons; open points are decided by a press.

import { button, element } from "../../parts/element.ts";
import { digits } from "../../parts/numbers.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Kind } from "./fields.ts";

const words = text.laboratory;

/** The result of `libration inspect`. */
export interface Inspection {
  readonly bytes: number;
  readonly format: string;
  readonly sheets: readonly { readonly name: string; readonly rows: number; readonly columns: readonly SheetColumn[] }[];
  readonly traces: readonly unknown[];
  readonly gate_times: number | null;
  readonly findings: readonly { text: string; option: string | null }[];
  readonly undecided: { why: string; options: readonly string[] } | null;
}

interface SheetColumn {
  readonly number: number;
  readonly name: string;
  readonly quantity: string;
  readonly unit: string | null;
  readonly numbers: number;
  readonly smallest: number | null;
  readonly largest: number | null;
}

/** The kind of fit for the file, if it is clear. */
export function kindOf({ traces, gate_times, sheets }: Inspection): Kind | undefined {
  if (sheets.some(isResponse)) return "response";
  if (traces.length > 0) return "trace";
  if (gate_times !== null) return "gates";
  const names = sheets.flatMap(({ columns }) => columns.map(({ name }) => name.toLowerCase()));
  const has = (word: string) => names.some((name) => name.includes(word));
  if (!has("period")) return undefined;
  return has("length") ? "lengths" : has("amplitude") || has("angle") ? "periods" : undefined;
}

// `true` for amplitudes against frequencies, which are not times even if they increase throughout.
function isResponse({ columns }: Inspection["sheets"][number]): boolean {
  const has = (word: string) => columns.some(({ name }) => name.toLowerCase().includes(word));
  return has("freq") && has("amplitude") && !columns.some(({ quantity }) => quantity === "time");
}

/** Shows the interpretation; `choose` enters a value for an option, `go` leads to its field. */
export function reading(name: string, found: Inspection, kind: Kind | undefined, choose: (option: string, value: string) => void, go: (option: string) => void): HTMLElement {
  const findings = found.findings.map(({ text: finding, option }) =>
    element("li", {}, finding, ...(option === null ? [] : [" ", button(option, () => go(option.slice(2)), { class: "small", "aria-label": words.change(option) })])),
  );
  return element(
    "article",
    { class: "reading" },
    element("h3", { class: "mono" }, name),
    element("p", { class: "quiet" }, words.format(found.format, found.bytes)),
    // Open points about swings do not matter to other fits.
    ...(kind === undefined || kind === "trace" ? undecided(found, choose) : []),
    ...found.sheets.map((sheet) => sheetTable(name, sheet)),
    element("details", {}, element("summary", {}, words.findings), element("ul", {}, ...findings)),
  );
}

function undecided({ undecided: open }: Inspection, choose: (option: string, value: string) => void): HTMLElement[] {
  if (open === null) return [];
  const buttons = open.options.map((option) => {
    const [name = "", ...value] = option.replace(/^--/, "").split(" ");
    return button(option, () => choose(name, value.join(" ") || "yes"));
  });
  return [element("p", { class: "error" }, words.undecided(open.why)), element("p", { class: "buttons" }, ...buttons)];
}

function sheetTable(file: string, { name, rows, columns }: Inspection["sheets"][number]): HTMLElement {
  const { number, name: title, quantity, unit, numbers, smallest, largest } = words.columns;
  const heads = [number, title, quantity, unit, numbers, smallest, largest].map((it, place) => ({ title: it, isNumber: place === 0 || place > 3 }));
  const lines = columns.map((column) => [
    String(column.number), column.name, column.quantity, column.unit ?? "", String(column.numbers), digits(column.smallest, 5), digits(column.largest, 5),
  ]);
  return table(words.table(name === "" ? file : name, rows), heads, lines);
}
