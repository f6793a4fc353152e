// The period against the amplitude: exact, by the small-angle approximation, and by the chosen formulas.

import type { Engine } from "../../engine/engine.ts";
import type { Mathematics } from "../../engine/mathematics.ts";
import { read } from "../../parts/answers.ts";
import { type Command, given } from "../../parts/command.ts";
import type { Periods } from "./catalogue.ts";

/** Number of intervals of a curve. */
const INTERVALS = 180;

/** The amplitudes at the ends of the picture, in degrees. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** Values of T/T₀ and their fractional errors at the amplitudes of the curves; NaN where a formula is not defined. */
export interface Curve {
  readonly key: string;
  readonly ratios: readonly number[];
  readonly errors: readonly number[];
}

/** Equally spaced amplitudes in degrees, below the top, where the period is infinite. */
export function amplitudes({ from, to }: Span): number[] {
  const all = Array.from({ length: INTERVALS + 1 }, (_, n) => from + ((to - from) * n) / INTERVALS);
  return all.filter((degrees) => degrees < 180);
}

/** The exact T/T₀ at an amplitude in degrees. */
export function exactRatio(mathematics: Mathematics, degrees: number): number {
  if (degrees === 0) return 1;
  const motion = mathematics.launch(`${degrees}deg`, 0, 1, 1);
  return "error" in motion ? NaN : motion.period / motion.smallAnglePeriod;
}

/** The query for the formulas at all these amplitudes. */
export function curvesCommand(keys: readonly string[], span: Span): Command {
  const all = amplitudes(span);
  const step = (span.to - span.from) / INTERVALS;
  const range = [span.from, all.at(-1) ?? span.to, step].map((degrees) => `${Number(degrees.toPrecision(15))}deg`).join(":");
  return { question: "period", arguments: [range], options: given({ formulas: keys.join(","), sort: "catalogue" }) };
}

/** The curves of the formulas, in the order of the keys. */
export async function curves(engine: Engine, keys: readonly string[], span: Span, signal: AbortSignal): Promise<{ degrees: number[]; all: Curve[] } | undefined> {
  const { value } = await read<Periods>(engine, curvesCommand(keys, span), signal);
  if (value === undefined) return undefined;
  const at = value.results.map(({ formulas }) => new Map(formulas.map((it) => [it.key, it])));
  const all = keys.map((key) => ({
    key,
    ratios: at.map((formulas) => formulas.get(key)?.ratio ?? NaN),
    errors: at.map((formulas) => formulas.get(key)?.fractional_error ?? NaN),
  }));
  return { degrees: value.results.map((it) => (it.amplitude_rad * 180) / Math.PI), all };
}
