// Thousands of initial states evenly spaced between two, as a table for the command, and the query about them.

import type { Starts } from "../../../engine/ensemble.ts";
import { type Command, extended, words } from "../../../parts/command.ts";

/** The name of the table in the command. */
export const FILE = "starts.csv";

/** The table of `count` initial states from one to the other, both as in `theta=0.2,theta'=1`; `undefined` unless all are numbers and the units agree. */
export function table(from: string, to: string, count: number): string | undefined {
  const [first, last] = [read(from), read(to)];
  if (first === undefined || last === undefined || first.size !== last.size) return undefined;
  const names = [...first.keys()];
  if (names.some((name) => first.get(name)?.unit !== last.get(name)?.unit)) return undefined;
  const between = (name: string, part: number) => {
    const [a, b] = [first.get(name), last.get(name)];
    if (a === undefined || b === undefined) return "";
    const value = part === 1 ? b.value : a.value + (b.value - a.value) * part;
    return `${Number(value.toPrecision(15))}${a.unit}`;
  };
  const rows = Array.from({ length: count }, (_, n) => names.map((name) => between(name, count > 1 ? n / (count - 1) : 0)).join(","));
  return `${[names.join(","), ...rows].join("\n")}\n`;
}

/** The names in an initial state, each with its number and unit. */
function read(start: string): Map<string, { value: number; unit: string }> | undefined {
  const found = new Map<string, { value: number; unit: string }>();
  for (const item of start.split(",")) {
    const [, name, value, unit = ""] = /^\s*([^=]+?)\s*=\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([a-zA-Z°/^\d]*)\s*$/.exec(item) ?? [];
    if (name === undefined || value === undefined) return undefined;
    found.set(name, { value: Number(value), unit });
  }
  return found;
}

/** The query that computes the same motions at given times. */
export function question(system: Command, tolerance: string, times: string): Command {
  return extended({ ...system, question: "simulate" }, { each: FILE, times, tolerance });
}

/** The same for motions that advance from one time to the next. */
export function starts(system: Command, tolerance: string, rows: string): Starts {
  return { words: words(question(system, tolerance, "0,1")), files: new Map([[FILE, new TextEncoder().encode(rows)]]) };
}

/** The rows of a table with these indices, from 0. */
export function some(rows: string, numbers: readonly number[]): string {
  const [head = "", ...lines] = rows.trimEnd().split("\n");
  return `${[head, ...numbers.map((number) => lines[number] ?? "")].join("\n")}\n`;
}
