// The interpretation of a table as sentences with buttons, each of which changes it.

import { choice } from "../../parts/choice.ts";
import { button, element } from "../../parts/element.ts";
import { plain } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";
import { type Key, keyOf, type Kind, labelIn, ROLES, taken } from "./fields.ts";
import type { SheetColumn } from "./reading.ts";

const words = text.laboratory.settings;

/** The values in the fields, and their change by a press. */
export interface Settings {
  readonly value: (key: string) => string;
  readonly put: (values: Readonly<Record<string, string>>) => void;
}

/** Sentences about units, swings per reading and columns; `told` is what the command has concluded from the file, as far as the fit has a result. */
export function sentences(kind: Kind, told: readonly string[], isKnown: boolean, columns: readonly SheetColumn[], settings: Settings): HTMLElement[] {
  const roles = rolesOf(told);
  const keys = taken(kind);
  const units = (["length-unit", "amplitude-unit", "response-unit", "frequency-unit"] as const).filter((key) => keys.includes(key) && isUsed(key, kind, roles));
  return [
    ...units.map((key) => unit(key, told, isKnown, settings)),
    ...(keys.includes("swings-per-reading") && !named(roles, "swings") ? [swings(told, isKnown, settings)] : []),
    ...(keys.includes("reaction-time") && !named(roles, "repeated readings") && !named(roles, "uncertainty of the period") ? [timing(settings)] : []),
    ...(keys.includes("columns") && columns.length > 0 ? [columnsTable(kind, roles, columns, settings)] : []),
  ];
}

/** The buttons that would follow the advice of a warning or an error, such as `--swings-per-reading 10`. */
export function remedies(sentence: string, kind: Kind | "inspect", { put }: Settings): HTMLElement[] {
  const found = [...sentence.matchAll(/--([a-z-]+)(?: (?!or\b|and\b|to\b)([\w./]+(?:,[\w.]+)*)(?: or ([\w./,]+))?)?/g)];
  return found.flatMap(([, option = "", value, other]) => {
    const key = keyOf(option, kind);
    if (key === undefined) return [];
    if (key === "half-periods") return [remedy(words.half, () => put({ "half-periods": "yes", "swings-per-reading": "" }))];
    if (key === "swings-per-reading" && value === undefined) return [10, 20].map((count) => remedy(words.count(count), () => put({ "half-periods": "", [key]: String(count) })));
    if (key === "length-unit" && value === undefined) return ["m", "cm"].map((unit) => remedy(words.lengthsIn(unit), () => put({ [key]: unit })));
    return [value, other].filter((it) => it !== undefined).map((it) => remedy(suggestion(key, it), () => put(key === "swings-per-reading" ? { "half-periods": "", [key]: it } : { [key]: it })));
  });
}

function remedy(label: string, press: () => void): HTMLElement {
  return button(label, press, { class: "small" });
}

/** The message as a sentence, without the advice that its buttons follow. */
export function advised(sentence: string, kind: Kind | "inspect", settings: Settings): (Node | string)[] {
  const buttons = remedies(sentence, kind, settings);
  const said = plain(buttons.length > 0 ? sentence.replace(/: give .*$/s, "") : sentence, labelIn(kind));
  return [`${said.charAt(0).toUpperCase()}${said.slice(1)}${/[.?!]$/.test(said) ? "" : "."}`, ...buttons.flatMap((it) => [" ", it])];
}

/** A value of a field as a button says it. */
export function suggestion(key: Key, value: string): string {
  const named = words.suggestions[key];
  const label = text.laboratory.fields[key].label;
  if (key === "swings-per-reading") return words.count(Number(value));
  return typeof named === "function" ? named(value) : words.put(label, value);
}

/** The columns of each role, by the sentences of the command. */
export function rolesOf(told: readonly string[]): Map<string, number[]> {
  const roles = new Map<string, number[]>();
  for (const sentence of told) {
    const [, role, list] = /^(?:read as (.*?)|not used): (.*)$/.exec(sentence) ?? [];
    if (list === undefined) continue;
    roles.set(role ?? "not used", [...list.matchAll(/column (\d+)/g)].map(([, number]) => Number(number)));
  }
  return roles;
}

function named(roles: ReadonlyMap<string, unknown>, word: string): boolean {
  return [...roles.keys()].some((role) => role.includes(word));
}

function isUsed(key: Key, kind: Kind, roles: ReadonlyMap<string, unknown>): boolean {
  if (key === "amplitude-unit") return kind === "periods" || named(roles, "amplitude");
  return true;
}

const QUANTITY: Readonly<Partial<Record<Key, string>>> = { "length-unit": "length", "amplitude-unit": "amplitude", "response-unit": "amplitude", "frequency-unit": "frequency" };
const UNITS: Readonly<Partial<Record<Key, readonly string[]>>> = {
  "length-unit": ["m", "cm", "mm", "in"], "amplitude-unit": ["deg", "rad"], "response-unit": ["deg", "rad", "m", "cm", "mm"], "frequency-unit": ["Hz", "rad/s"],
};
/** The units of numbers whose table states none. */
const USUAL: Readonly<Partial<Record<Key, string>>> = { "length-unit": "m", "amplitude-unit": "rad", "response-unit": "rad", "frequency-unit": "" };

function unit(key: "length-unit" | "amplitude-unit" | "response-unit" | "frequency-unit", told: readonly string[], isKnown: boolean, { value, put }: Settings): HTMLElement {
  const columns = rolesOf(told).get(QUANTITY[key] ?? "") ?? [];
  const written = told.map((sentence) => /^column (\d+).* is in (\S+?)[,;]?$/.exec(sentence)).find((it) => columns.includes(Number(it?.[1])))?.[2];
  const chosen = value(key);
  const now = chosen !== "" ? chosen : (written ?? (isKnown ? USUAL[key] : undefined) ?? "");
  const name = (it: string) => words.units[it] ?? it;
  const sentence = now === "" ? words.whichUnit[key] : chosen !== "" || written !== undefined ? words.unit[key](name(now)) : words.usualUnit[key](name(now));
  return choice(sentence, (UNITS[key] ?? []).map((it) => [name(it), it === now, () => put({ [key]: it })]));
}

function swings(told: readonly string[], isKnown: boolean, { value, put }: Settings): HTMLElement {
  const [, count] = told.map((sentence) => /(?:holds|read as) times of (half a period|one period|[\d.]+ periods)/.exec(sentence)).find((it) => it !== null) ?? [];
  const written = count === undefined ? (isKnown ? 1 : undefined) : count.startsWith("half") ? 0.5 : count.startsWith("one") ? 1 : parseFloat(count);
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

function columnsTable(kind: Kind, roles: ReadonlyMap<string, readonly number[]>, columns: readonly SheetColumn[], { value, put }: Settings): HTMLElement {
  const chosen = new Map(value(ROLES).split(",").filter((it) => it !== "").map((it) => it.split("=") as [string, string]));
  const rows = columns.map(({ number, name }) => {
    const found = [...roles].find(([, numbers]) => numbers.includes(number))?.[0];
    const select = element("select", {}, element("option", { value: "" }, words.asFound(found === undefined ? words.roles["ignore"] ?? "" : plain(found, labelIn(kind)))), ...ROLES_OF[kind].map((role) => element("option", { value: role }, words.roles[role] ?? role)));
    select.value = chosen.get(String(number)) ?? "";
    select.addEventListener("change", () => {
      if (select.value === "") chosen.delete(String(number));
      else chosen.set(String(number), select.value);
      put({ [ROLES]: Array.from(chosen, (pair) => pair.join("=")).join(",") });
    });
    return element("label", { class: "role" }, words.column(number, name), " ", select);
  });
  const list = [...roles].map(([role, numbers]) => words.readAs(role, numbers));
  return element("details", { class: "roles", open: chosen.size > 0 }, element("summary", {}, list.length > 0 ? list.join("; ") : words.columnsOpen), ...rows);
}
