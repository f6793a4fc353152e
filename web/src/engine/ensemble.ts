// Motions that advance together in a worker of their own, from one time to the next.

import { plainError, type QueryError } from "./engine.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";

/** The query `simulate … --each`, with the file of initial states that it names. */
export interface Starts {
  readonly words: readonly string[];
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/** Facts of the motions that stay the same in time. */
export interface EnsembleFacts {
  readonly count: number;
  readonly coordinates: number;
  /** Number of bodies of each motion that can be drawn. */
  readonly bodies: number;
  /** Period of the drive in s; NaN without a drive. */
  readonly period: number;
  /** Names of the state components. */
  readonly names: readonly string[];
  readonly units: readonly string[];
}

/** The motions at a time. */
export interface States {
  /** The state components of each motion, one motion after the other; NaN if it has ended. */
  readonly states: Float64Array;
  /** For each body of each motion, its position and that of its suspension point, each to the right and upwards. */
  readonly bodies: Float64Array;
  /** Number of motions that have ended, and the cause for the first one. */
  readonly ended: number;
  readonly cause: string;
}

export class Ensemble {
  readonly #worker: Worker;
  readonly facts: EnsembleFacts;

  private constructor(worker: Worker, facts: EnsembleFacts) {
    [this.#worker, this.facts] = [worker, facts];
  }

  /** Begins the motions in a worker, which it owns from then on; returns an error if that fails. */
  static async begin(worker: Worker, { words, files }: Starts): Promise<Ensemble | { readonly error: QueryError }> {
    const reply = await replied(worker, { kind: "ensemble", words, files });
    if (reply.kind === "begun" && reply.status === 0) return new Ensemble(worker, facts(reply.numbers, reply.text));
    worker.terminate();
    return { error: reply.kind === "begun" ? reply.error : plainError(reply.kind === "fault" ? reply.reason : "") };
  }

  /** The motions at a time, not before one that was requested already. */
  async at(time: number): Promise<States> {
    const reply = await replied(this.#worker, { kind: "advance", time });
    if (reply.kind === "states") return reply;
    throw new Error(reply.kind === "fault" ? reply.reason : reply.kind);
  }

  close(): void {
    this.#worker.terminate();
  }
}

function facts([count = 0, coordinates = 0, bodies = 0, period = NaN]: Float64Array, text: string): EnsembleFacts {
  const lines = text.trimEnd().split("\n").map((line) => line.split("\t"));
  return { count, coordinates, bodies, period, names: lines.map(([name = ""]) => name), units: lines.map(([, unit = ""]) => unit) };
}

/** The next message other than a module. */
function replied(worker: Worker, message: ToWorker): Promise<FromWorker> {
  return new Promise((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => data.kind !== "module" && resolve(data);
    worker.onerror = (event) => resolve({ kind: "fault", reason: event.message });
    worker.postMessage(message);
  });
}
