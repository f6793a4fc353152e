// An ensemble: motions from neighbouring initial states, some of which are recomputed to check how far they can be trusted.

import { Ensemble, type EnsembleFacts } from "../../../engine/ensemble.ts";
import type { Engine, QueryError } from "../../../engine/engine.ts";
import type { Command } from "../../../parts/command.ts";
import { some, starts } from "./starts.ts";

/** Number of recomputed motions, evenly spaced among all: as many as the library integrates at once. */
export const CHECKED = 16;
/** The tolerance of the recomputed motions. */
export const CLOSE = "1e-14";
/** Maximum number of workers: more would compete with each other and with the page. */
const MOST_WORKERS = 3;

/** The ensemble at a time. */
export interface Frame {
  readonly time: number;
  /** The state components of each motion. */
  readonly states: Float64Array;
  /** For each body of each motion, its position and that of its suspension point. */
  readonly bodies: Float64Array;
  /** The largest distance in a coordinate between two motions. */
  readonly spread: number;
  /** The largest distance in a coordinate between a motion and its recomputation. */
  readonly error: number;
  readonly ended: number;
  readonly cause: string;
}

export class Fleet {
  readonly facts: EnsembleFacts;
  readonly #parts: readonly Ensemble[];
  readonly #check: Ensemble;
  readonly #checked: readonly number[];

  private constructor(parts: readonly Ensemble[], check: Ensemble, checked: readonly number[]) {
    [this.#parts, this.#check, this.#checked] = [parts, check, checked];
    const count = parts.reduce((sum, { facts }) => sum + facts.count, 0);
    this.facts = { ...check.facts, count };
  }

  /** Begins the motions of a table of initial states, a part of them in each worker; returns an error if that fails. */
  static async begin(engine: Engine, system: Command, tolerance: string, rows: string): Promise<Fleet | { readonly error: QueryError }> {
    const count = rows.trimEnd().split("\n").length - 1;
    const checked = evenly(count, Math.min(CHECKED, count));
    // The first worker starts alone: an error is reported once, and the others receive the compiled module.
    const check = await Ensemble.begin(await engine.worker(), starts(system, CLOSE, some(rows, checked)));
    if ("error" in check) return check;
    const workers = Math.min(Math.max(1, navigator.hardwareConcurrency - 1), MOST_WORKERS, Math.ceil(count / CHECKED));
    const bounds = Array.from({ length: workers + 1 }, (_, n) => Math.round((n * count) / workers));
    const pieces = bounds.slice(1).map((end, n) => Array.from({ length: end - (bounds[n] ?? 0) }, (_, i) => (bounds[n] ?? 0) + i));
    const begun = await Promise.all(pieces.map(async (piece) => Ensemble.begin(await engine.worker(), starts(system, tolerance, some(rows, piece)))));
    const parts = begun.filter((part) => part instanceof Ensemble);
    const refused = begun.find((part) => "error" in part);
    if (refused === undefined) return new Fleet(parts, check, checked);
    for (const part of [check, ...parts]) part.close();
    return refused as { readonly error: QueryError };
  }

  /** The ensemble at a time, not before one that was requested already. */
  async at(time: number): Promise<Frame> {
    const [check, ...parts] = await Promise.all([this.#check, ...this.#parts].map((part) => part.at(time)));
    const states = joined(parts.map((part) => part.states));
    const [width, coordinates] = [this.facts.names.length, this.facts.coordinates];
    const close = check?.states ?? new Float64Array();
    return {
      time,
      states,
      bodies: joined(parts.map((part) => part.bodies)),
      spread: spread(states, width, coordinates),
      error: error(states, close, this.#checked, width, coordinates),
      ended: parts.reduce((sum, { ended }) => sum + ended, 0),
      cause: parts.find(({ ended }) => ended > 0)?.cause ?? "",
    };
  }

  close(): void {
    for (const part of [this.#check, ...this.#parts]) part.close();
  }
}

/** Evenly spaced numbers from 0 to below a count. */
function evenly(count: number, many: number): number[] {
  return Array.from({ length: many }, (_, n) => Math.round((n * (count - 1)) / Math.max(1, many - 1)));
}

function joined(parts: readonly Float64Array[]): Float64Array {
  const [only] = parts;
  if (parts.length === 1 && only !== undefined) return only;
  const all = new Float64Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

function spread(states: Float64Array, width: number, coordinates: number): number {
  let largest = 0;
  for (let coordinate = 0; coordinate < coordinates; coordinate++) {
    let [least, most] = [Infinity, -Infinity];
    for (let at = coordinate; at < states.length; at += width) {
      const value = states[at] ?? NaN;
      if (value < least) least = value;
      if (value > most) most = value;
    }
    largest = Math.max(largest, most - least);
  }
  return largest;
}

function error(states: Float64Array, close: Float64Array, checked: readonly number[], width: number, coordinates: number): number {
  let largest = 0;
  for (const [place, number] of checked.entries()) {
    for (let coordinate = 0; coordinate < coordinates; coordinate++) {
      const distance = Math.abs((states[number * width + coordinate] ?? NaN) - (close[place * width + coordinate] ?? NaN));
      if (distance > largest) largest = distance;
    }
  }
  return largest;
}
