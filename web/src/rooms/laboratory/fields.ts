// The options of the room, and the fits that take them.

import { choiceField, type Field, textField, tickField } from "../../parts/field.ts";
import { plainly } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";

const words = text.laboratory.fields;

export const KINDS = ["trace", "gates", "periods", "lengths", "amplitudes", "response"] as const;
export type Kind = (typeof KINDS)[number];
export type Key = keyof typeof words;

const APPARATUS: readonly Key[] = ["length", "bob-radius", "bob-mass", "bob-density", "rod-mass", "rod-length", "air-density", "stretch", "angle-scale", "clock"];
const READING: readonly Key[] = [
  "time", "time-unit", "frame-rate", "angle", "angular-velocity", "unit", "counts-per-turn", "x", "y", "pivot", "uncertainty", "gate", "signal", "from", "to", "even-times", "times-as-written", "run", "sheet", "delimiter", "decimal", "header",
];
const DIALECT: readonly Key[] = ["sheet", "delimiter", "decimal", "header"];
const TABLE: readonly Key[] = ["columns", "least", "most", "groups", ...DIALECT];
const TIMING: readonly Key[] = ["group", "half-periods", "swings-per-reading", "reaction-time", "shared-timing"];
const RESPONSE: readonly Key[] = ["oscillator", "measured", "frequency-unit", "response-unit", "phase-unit", "errors"];
const DECAY: readonly Key[] = ["model", "against", "sides", "period", "response-unit", "errors"];
const CHOICES: readonly Key[] = [
  "model", "robust", "free-scale", "signals", "diameter", "shape", "gate-distance", "amplitude", "columns", "least", "most", "groups", "amplitude-unit", "length-unit", "pendulum", "edges", ...TIMING, "reject-outliers", "linear-damping", "against", "sides", "period", ...RESPONSE,
];

/** The fields in the order in which they are shown: options of the fit, the apparatus, reading of the files. */
export const PARTS = { choices: CHOICES, apparatus: APPARATUS, reading: READING } as const;

const TAKEN: Readonly<Record<Kind, readonly Key[]>> = {
  trace: ["model", "robust", "free-scale", ...APPARATUS, ...READING],
  gates: ["signals", "diameter", "shape", "gate-distance", "amplitude", "linear-damping", ...APPARATUS, ...READING],
  periods: [...TABLE, ...TIMING, "amplitude", "amplitude-unit", "reject-outliers", "linear-damping", ...APPARATUS],
  lengths: [...TABLE, ...TIMING, "length-unit", "amplitude", "amplitude-unit", "pendulum", "edges", "bob-radius", "clock"],
  amplitudes: [...TABLE, ...DECAY, "length"],
  response: [...TABLE, ...RESPONSE],
};

/** Options that have another meaning in another fit, or had another name, by their fields; links keep the names of fields. */
const OPTIONS: Readonly<Partial<Record<Key, string>>> = { oscillator: "model", pendulum: "model", "response-unit": "amplitude-unit", unit: "angle-unit", "linear-damping": "linear", least: "from", most: "to", groups: "run" };

/** The key of the roles of columns, such as `2=ignore,4=period`, which are chosen in the table of columns. */
export const ROLES = "roles";

const TICKS = new Set<Key>(["robust", "free-scale", "half-periods", "even-times", "times-as-written"]);
/** Numbers with units, in which a comma can only be a decimal comma. */
const QUANTITIES = new Set<Key>([...APPARATUS, "diameter", "gate-distance", "amplitude", "edges", "swings-per-reading", "reaction-time", "shared-timing", "reject-outliers", "linear-damping", "period", "counts-per-turn", "frame-rate", "from", "to", "least", "most"]);
const SELECTED = new Set<Key>(["delimiter", "decimal", "signals", "shape", "oscillator", "pendulum", "measured", "against", "sides", "errors"]);
const UNITS: Readonly<Partial<Record<Key, readonly string[]>>> = {
  "frequency-unit": ["Hz", "kHz", "rad/s", "deg/s"],
  "response-unit": ["rad", "deg", "m", "cm", "mm", "in", "counts"],
  "amplitude-unit": ["rad", "deg"],
  "phase-unit": ["rad", "deg"],
  "length-unit": ["m", "dm", "cm", "mm", "in", "ft"],
};

/** The option of a field. */
export function optionOf(key: string): string {
  return OPTIONS[key as Key] ?? key;
}

/** The fields of a fit, or of `inspect`, that are passed as options. */
export function taken(kind: Kind | "inspect"): readonly Key[] {
  return kind === "inspect" ? READING : TAKEN[kind];
}

/** The field of an option in a fit. */
export function keyOf(option: string, kind: Kind | "inspect"): Key | undefined {
  return taken(kind).find((key) => optionOf(key) === option);
}

/** The name of an option, or of a fit, on the page. */
export function labelIn(kind: Kind | "inspect"): (name: string) => string | undefined {
  return (name) => {
    const key = keyOf(name, kind) ?? keyOf(name, "inspect");
    return key === undefined ? (text.laboratory.kind as Readonly<Record<string, string>>)[name.replace(/^fit /, "")] : words[key].label;
  };
}

/** The value of a field as the command takes it: decimal commas become points where no list is meant. */
export function valueOf(key: Key, entered: string): string | boolean {
  if (TICKS.has(key)) return entered === "yes";
  return QUANTITIES.has(key) ? entered.replace(/(\d),(?=\d)/g, "$1.") : entered;
}

export function fields(label: (name: string) => string | undefined): Field[] {
  const { kind } = text.laboratory;
  const kinds = (["auto", ...KINDS] as const).map((key): [string, string] => [key, kind[key]]);
  const keys = new Set<Key>([...CHOICES, ...APPARATUS, ...READING]);
  const roles = textField({ key: ROLES, words: { label: text.laboratory.columns.role } });
  return [choiceField({ key: "kind", words: { label: kind.label }, initial: "auto" }, kinds), roles, ...Array.from(keys, (key) => plainly(field(key), label))];
}

function field(key: Key): Field {
  const description = { key, option: `--${optionOf(key)}`, words: words[key] };
  if (TICKS.has(key)) return tickField(description);
  if (SELECTED.has(key)) return choiceField(description, named(words[key]));
  const units = UNITS[key];
  if (units !== undefined) return choiceField(description, ["", ...units].map((unit) => [unit, unit === "" ? words.delimiter.auto : unit]));
  return textField(key === "amplitude" ? { ...description, unit: "rad", isShort: true } : description);
}

function named({ label: _, hint: __, auto, ...choices }: Readonly<Record<string, string>>): [string, string][] {
  return [["", auto ?? ""], ...Object.entries(choices)];
}
