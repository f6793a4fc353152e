// The gauge: the meaning of ε, in words or as coefficients.

import { text } from "../../texts/en.ts";

const { gauges } = text.perturbation;

/** The entries that the field suggests. */
export const SUGGESTIONS: readonly string[] = [...Object.values(gauges), "A1=1,A3=-1"];

/** The gauge as the command takes it. */
export function gaugeOf(entry: string): string {
  return Object.entries(gauges).find(([, words]) => words === entry.toLowerCase())?.[0] ?? entry;
}
