// Approximate pendulums, shown with the exact one.

import type { Mathematics, Motion } from "../../engine/mathematics.ts";
import type { Colour } from "../../parts/colours.ts";

export interface Ghost {
  readonly key: string;
  readonly colour: Colour;
  angles(first: number, step: number, count: number): Float64Array;
}

/** Approximate motions of the library, in the order of its catalogue. */
export const APPROXIMATIONS = ["small-angle", "fourier-3", "fourier-5", "fourier-7"] as const;
const COLOURS: readonly Colour[] = ["curve-2", "curve-3", "curve-4", "curve-5"];

/** The motion of an approximation; `undefined` if it does not apply to such an initial state. */
export function approximate(mathematics: Mathematics, key: string): Ghost | undefined {
  const place = APPROXIMATIONS.findIndex((known) => known === key);
  const colour = COLOURS[place];
  if (colour === undefined || mathematics.approximation(place, 0, 0, 1) === undefined) return undefined;
  return { key, colour, angles: (first, step, count) => mathematics.approximation(place, first, step, count) ?? new Float64Array(count).fill(NaN) };
}

/** The exact motion, rescaled to the period of a formula. */
export function withPeriod(mathematics: Mathematics, key: string, motion: Motion, period: number): Ghost {
  const faster = motion.period / period;
  return { key, colour: "curve-6", angles: (first, step, count) => mathematics.states(first * faster, step * faster, count).angles };
}
