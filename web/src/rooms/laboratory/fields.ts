// The options of the room, and the fits that take them.

import { choiceField, type Field, textField, tickField } from "../../parts/field.ts";
import { text } from "../../texts/en.ts";

const words = text.laboratory.fields;

export type Kind = "trace" | "gates" | "periods" | "lengths" | "response";
type Key = keyof typeof words;

const APPARATUS: readonly Key[] = ["length", "bob-radius", "bob-mass", "bob-density", "rod-mass", "rod-length", "air-density", "stretch", "angle-scale", "clock"];
const READING: readonly Key[] = [
  "time", "time-unit", "angle", "angular-velocity", "unit", "counts-per-turn", "x", "y", "pivot", "uncertainty", "gate", "from", "to", "even-times", "times-as-written", "run", "sheet", "delimiter", "decimal", "header",
];
const TABLE: readonly Key[] = ["columns", "half-periods", "swings-per-reading", "delimiter", "header"];
const RESPONSE: readonly Key[] = ["oscillator", "measured", "frequency-unit", "response-unit", "phase-unit"];
const CHOICES: readonly Key[] = ["model", "robust", "free-scale", "signals", "diameter", "gate-distance", "amplitude", "columns", "amplitude-unit", "length-unit", "half-periods", "swings-per-reading", "reject-outliers", "linear-damping", ...RESPONSE];

/** The fields in the order in which they are shown: options of the fit, the apparatus, reading of the files. */
export const PARTS = { choices: CHOICES, apparatus: APPARATUS, reading: READING } as const;

const TAKEN: Readonly<Record<Kind, readonly Key[]>> = {
  trace: ["model", "robust", "free-scale", ...APPARATUS, ...READING],
  gates: ["signals", "diameter", "gate-distance", "amplitude", "linear-damping", ...APPARATUS, ...READING],
  periods: [...TABLE, "amplitude-unit", "reject-outliers", "linear-damping", ...APPARATUS],
  lengths: [...TABLE, "length-unit", "amplitude", "amplitude-unit", "bob-radius", "clock"],
  response: [...RESPONSE, "columns", "delimiter", "header"],
};

/** Options that have another meaning in another fit, or had another name, by their fields; links keep the names of fields. */
const OPTIONS: Readonly<Partial<Record<Key, string>>> = { oscillator: "model", "response-unit": "amplitude-unit", unit: "angle-unit", "linear-damping": "linear" };

/** The option of a field. */
export function optionOf(key: string): string {
  return OPTIONS[key as Key] ?? key;
}

/** The options of a fit, or of `inspect`. */
export function taken(kind: Kind | "inspect"): readonly string[] {
  return kind === "inspect" ? READING : TAKEN[kind];
}

const TICKS = new Set<Key>(["robust", "free-scale", "half-periods", "even-times", "times-as-written"]);

export function fields(): Field[] {
  const { kind } = text.laboratory;
  const kinds = (["auto", "trace", "gates", "periods", "lengths", "response"] as const).map((key): [string, string] => [key, kind[key]]);
  const keys = new Set<Key>([...CHOICES, ...APPARATUS, ...READING]);
  return [choiceField({ key: "kind", words: { label: kind.label }, initial: "auto" }, kinds), ...Array.from(keys, field)];
}

function field(key: Key): Field {
  const description = { key, option: `--${optionOf(key)}`, words: words[key] };
  if (TICKS.has(key)) return tickField(description);
  if (key === "delimiter" || key === "decimal" || key === "signals" || key === "oscillator" || key === "measured") return choiceField(description, named(words[key]));
  if (key === "frequency-unit") return choiceField(description, units("Hz", "kHz", "rad/s", "deg/s"));
  if (key === "response-unit") return choiceField(description, units("rad", "deg", "m", "cm", "mm", "in", "counts"));
  if (key === "amplitude-unit" || key === "phase-unit") return choiceField(description, units("rad", "deg"));
  if (key === "amplitude") return textField({ ...description, unit: "rad" });
  return key === "length-unit" ? choiceField(description, units("m", "cm", "mm", "in")) : textField(description);
}

function named({ label: _, auto, ...choices }: Readonly<Record<string, string>>): [string, string][] {
  return [["", auto ?? ""], ...Object.entries(choices)];
}

function units(...all: string[]): [string, string][] {
  return ["", ...all].map((unit) => [unit, unit === "" ? words.delimiter.auto : unit]);
}
