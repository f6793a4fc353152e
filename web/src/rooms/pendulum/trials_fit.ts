// Gravity from the table of trials, by the fits of the laboratory.

import type { Engine } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { type Command, given } from "../../parts/command.ts";
import { explained } from "../../parts/marks.ts";
import { plain } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";
import type { Trial } from "./trials.ts";

const words = text.pendulum.trials;

/** The table as a file, and the fit for it: over the lengths if there are three, otherwise over the amplitudes. */
export interface Fit {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly command: Command;
  /** Number of trials that lack what the fit needs. */
  readonly leftOut: number;
}

/** The result of a fit, as far as it is shown here. */
interface Gravity {
  readonly gravity_m_per_s2?: number | null;
  readonly gravity_uncertainty_m_per_s2?: number | null;
  readonly gravity_expanded_uncertainty_m_per_s2?: number | null;
  readonly beta?: number | null;
  readonly beta_uncertainty?: number | null;
  readonly budget_inputs?: readonly { readonly input: string; readonly share: number | null }[];
  readonly warnings?: readonly string[];
  readonly warning_kinds?: readonly string[];
}

/** `lengthError` in metres; `timeError`, in seconds, of each reading, if it is known. */
export function fitOf(trials: readonly Trial[], lengthError: number, timeError: number | undefined): Fit | string {
  const complete = trials.filter(({ amplitude, length }) => Number.isFinite(amplitude) && length > 0);
  const lengths = [...new Set(complete.map(({ length }) => length))];
  if (complete.length === 0) return words.noTrials;
  const isOverLengths = lengths.length >= 3;
  if (!isOverLengths && lengths.length !== 1) return words.oneLength;
  const rows = complete.flatMap(({ amplitude, length, swings, periods }) => periods.map((period) => ({ amplitude, length, period, error: (timeError ?? 0) / swings })));
  const name = "trials.csv";
  const withErrors = timeError !== undefined;
  const head = isOverLengths ? ["length (m)", "period (s)", "u(length) (m)"] : ["amplitude (deg)", "period (s)"];
  const lines = rows.map((row) => [...(isOverLengths ? [row.length, row.period, lengthError] : [row.amplitude, row.period]), ...(withErrors ? [row.error] : []), ...(isOverLengths ? [row.amplitude] : [])].join(","));
  const columns = [...head, ...(withErrors ? ["u(period) (s)"] : []), ...(isOverLengths ? ["amplitude (deg)"] : [])];
  const bytes = new TextEncoder().encode(`${[columns.join(","), ...lines].join("\n")}\n`);
  const options = isOverLengths ? given({ columns: withErrors ? "1,2,3,4,5" : "1,2,3,-,4" }) : given({ length: `${lengths[0]} ± ${lengthError} m` });
  return { name, bytes, leftOut: trials.length - complete.length, command: { question: isOverLengths ? "fit lengths" : "fit periods", arguments: [name], options } };
}

/** The headline and its reasons. */
export interface Finding {
  readonly headline: string;
  readonly reasons: readonly string[];
}

/** Runs a fit; a bench elsewhere than on the Earth needs no warning that its gravity is not found there. */
export async function fitted(engine: Engine, { name, bytes, command }: Fit, isOnEarth: boolean, signal: AbortSignal): Promise<Finding | string> {
  const { answer, value } = await read<Gravity>(engine, command, signal, new Map([[name, bytes]]));
  if (value === undefined || answer.status !== 0) return plain(explained({ ...answer.error, subject: "" }));
  const [gravity, error, expanded] = [value.gravity_m_per_s2, value.gravity_uncertainty_m_per_s2, value.gravity_expanded_uncertainty_m_per_s2];
  if (gravity == null || error == null) return words.noGravity;
  const reasons = [
    ...(expanded == null ? [] : [words.expanded(rounded(expanded, expanded)[1])]),
    ...(value.budget_inputs ?? []).filter(({ share }) => share !== null && share > 0.01).map(({ input, share }) => words.share(input, `${(100 * (share ?? 0)).toFixed(0)} %`)),
    ...(value.beta != null && value.beta_uncertainty != null && value.beta_uncertainty > 0 ? [words.beta(...rounded(value.beta, value.beta_uncertainty))] : []),
    ...(value.warnings ?? []).filter((_, place) => isOnEarth || value.warning_kinds?.[place] !== "gravity_contradicted").map((warning) => plain(warning)),
  ];
  return { headline: words.headline(...rounded(gravity, error)), reasons };
}

/** A value with its uncertainty to two digits. */
export function rounded(value: number, error: number): [value: string, error: string] {
  const two = Number(error.toPrecision(2));
  const decimals = two > 0 ? Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(two)))) : 3;
  return [value.toFixed(decimals).replace("-", "−"), two.toFixed(decimals)];
}
