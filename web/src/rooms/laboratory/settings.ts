// The interpretation of a table as sentences with buttons, each of which changes it.

import { choice } from "../../parts/choice.ts";
import { button, element } from "../../parts/element.ts";
import { marks } from "../../parts/marks.ts";
import { plain } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";
import { type Key, keyOf, type Kind, labelIn, ROLES, taken } from "./fields.ts";
import type { ReadColumn, SheetColumn } from "./reading.ts";

const words = text.laboratory.settings;

/** The values in the fields, and their change by a press. */
export interface Settings {
  readonly value: (key: string) => string;
  readonly put: (values: Readonly<Record<string, string>>) => void;
}

/** Sentences about units, swings per reading and columns; `read` are the columns with the roles that the command gave them. */
export function sentences(kind: Kind, read: readonly ReadColumn[], columns: readonly SheetColumn[], settings: Settings): HTMLElement[] {
  const has = (role: string) => read.some((it) => it.role === role);
  const isRepeated = read.filter(({ role }) => role === "period").length > 1;
  const keys = taken(kind);
  const units = (["length-unit", "amplitude-unit", "response-unit", "frequency-unit"] as const).filter((key) => keys.includes(key) && (key !== "amplitude-unit" || kind === "periods" || has("amplitude")));
  return [
    ...units.map((key) => unit(key, read, settings)),
    ...(keys.includes("swings-per-reading") && !has("swings") ? [swings(read, settings)] : []),
    ...(keys.includes("reaction-time") && !isRepeated && !read.some(({ role }) => role.startsWith("period-")) ? [timing(settings)] : []),
    ...(keys.includes("columns") && columns.length > 0 ? [columnsTable(kind, read, columns, settings)] : []),
  ];
}

/** The buttons that would follow the advice of a warning or an error: one for each value of its marks. */
export function remedies(sentence: string, kind: Kind | "inspect", { put }: Settings): HTMLElement[] {
  return marks(sentence).flatMap((it) => {
    const key = typeof it === "string" ? undefined : keyOf(it.name, kind);
    if (typeof it === "string" || key === undefined) return [];
    if (key === "half-periods") return [remedy(words.half, () => put({ "half-periods": "yes", "swings-per-reading": "" }))];
    const values = key === "swings-per-reading" && it.values.length === 0 ? ["10", "20"] : it.values;
    return values.map((value) => remedy(suggestion(key, value), () => put(key === "swings-per-reading" ? { "half-periods": "", [key]: value } : { [key]: value })));
  });
}

function remedy(label: string, press: () => void): HTMLElement {
  return button(label, press, { class: "small" });
}

/** The message as a sentence, with buttons that follow its advice. */
export function advised(sentence: string, kind: Kind | "inspect", settings: Settings): (Node | string)[] {
  const buttons = remedies(sentence, kind, settings);
  const said = plain(sentence, labelIn(kind));
  return [`${said.charAt(0).toUpperCase()}${said.slice(1)}${/[.?!]$/.test(said) ? "" : "."}`, ...buttons.flatMap((it) => [" ", it])];
}

/** A value of a field as a button says it. */
export function suggestion(key: Key, value: string): string {
  const named = words.suggestions[key];
  const label = text.laboratory.fields[key].label;
  if (key === "swings-per-reading") return words.count(Number(value));
  return typeof named === "function" ? named(value) : words.put(label, value);
}

const QUANTITY: Readonly<Partial<Record<Key, string>>> = { "length-unit": "length", "amplitude-unit": "amplitude", "response-unit": "amplitude", "frequency-unit": "frequency" };
const UNITS: Readonly<Partial<Record<Key, readonly string[]>>> = {
  "length-unit": ["m", "cm", "mm", "in"], "amplitude-unit": ["deg", "rad"], "response-unit": ["deg", "rad", "m", "cm", "mm"], "frequency-unit": ["Hz", "rad/s"],
};

function unit(key: "length-unit" | "amplitude-unit" | "response-unit" | "frequency-unit", read: readonly ReadColumn[], { value, put }: Settings): HTMLElement {
  const column = read.find(({ role }) => role === QUANTITY[key]);
  const chosen = value(key);
  const now = chosen !== "" ? chosen : (column?.unit ?? "");
  const name = (it: string) => words.units[it] ?? it;
  const sentence = now === "" ? words.whichUnit[key] : chosen !== "" || column?.unit_is_stated === true ? words.unit[key](name(now)) : words.usualUnit[key](name(now));
  return choice(sentence, (UNITS[key] ?? []).map((it) => [name(it), it === now, () => put({ [key]: it })]));
}

function swings(read: readonly ReadColumn[], { value, put }: Settings): HTMLElement {
  const written = read.find(({ role }) => role === "period")?.swings ?? undefined;
  const now = value("half-periods") === "yes" ? 0.5 : Number(value("swings-per-reading")) || written;
  const choices = [...new Set([0.5, 1, 5, 10, 20, now ?? 1])].sort((a, b) => a - b);
  const press = (it: number) => put(it === 0.5 ? { "half-periods": "yes", "swings-per-reading": "" } : { "half-periods": "", "swings-per-reading": String(it) });
  return choice(now === undefined ? words.howManySwings : words.swings(now), choices.map((it) => [words.number(it), it === now, () => press(it)]));
}

// Repeated readings have the uncertainty of a timing by hand in their scatter, and stated uncertainties contain it.
function timing({ value, put }: Settings): HTMLElement {
  const now = value("reaction-time");
  const choices = [...new Set(["", "0.05 s", "0.1 s", "0.2 s", now])];
  return choice(words.timing, choices.map((it) => [it === "" ? words.notStated : it, it === now, () => put({ "reaction-time": it })]));
}

/** The roles that are offered for a column, in the words of the command. */
const ROLES_OF: Readonly<Record<Kind, readonly string[]>> = {
  lengths: ["length", "period", "length-uncertainty", "period-uncertainty", "amplitude", "swings", "group", "ignore"],
  periods: ["amplitude", "period", "amplitude-uncertainty", "period-uncertainty", "swings", "group", "ignore"],
  amplitudes: ["position", "swing-number", "amplitude", "amplitude-uncertainty", "period", "group", "ignore"],
  response: ["frequency", "amplitude", "amplitude-uncertainty", "phase", "phase-uncertainty", "ignore"],
  trace: [],
  gates: [],
};

function nameOf(role: string): string {
  return words.roles[role] ?? role.replaceAll("-", " ");
}

function columnsTable(kind: Kind, read: readonly ReadColumn[], columns: readonly SheetColumn[], { value, put }: Settings): HTMLElement {
  const chosen = new Map(value(ROLES).split(",").filter((it) => it !== "").map((it) => it.split("=") as [string, string]));
  const rows = columns.map(({ number, name }) => {
    const select = element("select", {}, element("option", { value: "" }, words.asFound(nameOf(read.find((it) => it.number === number)?.role ?? "ignore"))), ...ROLES_OF[kind].map((role) => element("option", { value: role }, nameOf(role))));
    select.value = chosen.get(String(number)) ?? "";
    select.addEventListener("change", () => {
      if (select.value === "") chosen.delete(String(number));
      else chosen.set(String(number), select.value);
      put({ [ROLES]: Array.from(chosen, (pair) => pair.join("=")).join(",") });
    });
    return element("label", { class: "role" }, words.column(number, name), " ", select);
  });
  const roles = [...new Set(read.map(({ role }) => role))];
  const list = roles.map((role) => words.readAs(nameOf(role), read.filter((it) => it.role === role).map(({ number }) => number)));
  return element("details", { class: "roles", open: chosen.size > 0 }, element("summary", {}, list.length > 0 ? list.join("; ") : words.columnsOpen), ...rows);
}
