// The command's interpretation of a file, with its reasons; open points are decided by a press.

import { button, element } from "../../parts/element.ts";
import { digits } from "../../parts/numbers.ts";
import { plain } from "../../parts/plain.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import { type Key, keyOf, type Kind, labelIn } from "./fields.ts";
import { advised, remedies, type Settings } from "./settings.ts";

const words = text.laboratory;

/** The result of `libration inspect`. */
export interface Inspection {
  readonly bytes: number;
  readonly format: string;
  readonly sheets: readonly { readonly name: string; readonly rows: number; readonly columns: readonly SheetColumn[] }[];
  readonly traces: readonly unknown[];
  readonly gate_times: number | null;
  /** The fit of a table whose headings name its quantities. */
  readonly table_fit?: string;
  readonly table_columns?: readonly ReadColumn[];
  readonly findings: readonly { text: string; option: string | null }[];
  readonly undecided: { why: string } | null;
  /** Signals in which passages of a gate are found. */
  readonly undecided_gate?: { why: string };
}

/** A column with its role: the word of `--role`, such as `length` or `period-uncertainty`. */
export interface ReadColumn {
  readonly number: number;
  readonly role: string;
  readonly unit: string | null;
  readonly unit_is_stated: boolean;
  readonly swings: number | null;
}

export interface SheetColumn {
  readonly number: number;
  readonly name: string;
  readonly quantity: string;
  readonly unit: string | null;
  readonly numbers: number;
  readonly smallest: number | null;
  readonly largest: number | null;
}

/** The table of the file and what was inferred from it, folded; `go` leads to the field of an inference. */
export function reading(name: string, found: Inspection, go: (key: Key) => void): HTMLElement {
  const findings = found.findings.map(({ text: finding, option }) => {
    const key = option === null ? undefined : keyOf(option.slice(2), "inspect");
    const change = key === undefined ? [] : [" ", button(words.changeShort, () => go(key), { class: "small", "aria-label": words.change(words.fields[key].label) })];
    return element("li", {}, plain(finding, labelIn("inspect")), ...change);
  });
  return element(
    "details",
    { class: "reading" },
    element("summary", {}, element("span", { class: "mono" }, name), ` ${words.format(found.format, found.bytes)}`),
    ...found.sheets.map((sheet) => sheetTable(name, sheet)),
    element("h3", {}, words.findings),
    element("ul", {}, ...findings),
  );
}

/** What a recorded swing and the passages of a gate leave open, with a button for each choice. */
export function undecided(name: string, { undecided: swing, undecided_gate: gate }: Inspection, settings: Settings): HTMLElement[] {
  const offered = new Set<string | null>();
  return [...open(words.undecided, name, swing?.why, settings, offered), ...open(words.undecidedGate, name, gate?.why, settings, offered)];
}

/** A question with its choices, but those that another one offers already. */
function open(sentence: (name: string, why: string) => string, name: string, why: string | undefined, settings: Settings, offered: Set<string | null>): HTMLElement[] {
  if (why === undefined) return [];
  const choices = remedies(why, "inspect", settings).filter((choice) => !offered.has(choice.textContent));
  choices.forEach((choice) => offered.add(choice.textContent));
  // Without a choice there is nothing that a press could decide.
  const attributes = choices.length > 0 ? {} : { class: "error" };
  return [element("p", attributes, sentence(name, plain(why, labelIn("inspect")))), element("p", { class: "buttons" }, ...choices)];
}

/** A file that cannot be read, with the buttons that its message suggests; the others are not affected. */
export function unreadable(name: string, failure: string, kind: Kind | "inspect", settings: Settings): HTMLElement {
  return element(
    "article",
    { class: "reading" },
    element("h3", { class: "mono" }, name),
    element("p", { class: "error" }, ...advised(failure, kind, settings)),
  );
}

function sheetTable(file: string, { name, rows, columns }: Inspection["sheets"][number]): HTMLElement {
  const { number, name: title, quantity, unit, numbers, smallest, largest } = words.columns;
  const heads = [number, title, quantity, unit, numbers, smallest, largest].map((it, place) => ({ title: it, isNumber: place === 0 || place > 3 }));
  const lines = columns.map((column) => [
    String(column.number), column.name, column.quantity, column.unit ?? "", String(column.numbers), digits(column.smallest, 5), digits(column.largest, 5),
  ]);
  return table(words.table(name === "" ? file : name, rows), heads, lines);
}
