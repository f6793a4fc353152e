// Motions that go on together in a worker of their own, from one time to the next.

import { plainError, type QueryError } from "./engine.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";

/** The question `simulate … --each`, with the file of starts that it names. */
export interface Starts {
  readonly words: readonly string[];
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/** What is followed. */
export interface EnsembleFacts {
  readonly count: number;
  readonly coordinates: number;
  /** How many bodies each motion has that can be drawn. */
  readonly bodies: number;
  /** That of the drive in s; NaN without one. */
  readonly period: number;
  /** Of the numbers of a state. */
  readonly names: readonly string[];
  readonly units: readonly string[];
}

/** The motions at a time. */
export interface States {
  /** Of each motion the numbers of its state, one behind the other; NaN where it has ended. */
  readonly states: Float64Array;
  /** Of each motion, of each body: its place and that on which it hangs, each to the right and upwards. */
  readonly bodies: Float64Array;
  /** How many motions have ended, and why the first one has. */
  readonly ended: number;
  readonly cause: string;
}

export class Ensemble {
  readonly #worker: Worker;
  readonly facts: EnsembleFacts;

  private constructor(worker: Worker, facts: EnsembleFacts) {
    [this.#worker, this.facts] = [worker, facts];
  }

  /** Begins the motions in a worker, which it owns from then on; or says why not. */
  static async begin(worker: Worker, { words, files }: Starts): Promise<Ensemble | { readonly error: QueryError }> {
    const reply = await replied(worker, { kind: "ensemble", words, files });
    if (reply.kind === "begun" && reply.status === 0) return new Ensemble(worker, facts(reply.numbers, reply.text));
    worker.terminate();
    return { error: reply.kind === "begun" ? reply.error : plainError(reply.kind === "fault" ? reply.reason : "") };
  }

  /** The motions at a time, not before one that was asked for already. */
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

/** The next message that is no module. */
function replied(worker: Worker, message: ToWorker): Promise<FromWorker> {
  return new Promise((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => data.kind !== "module" && resolve(data);
    worker.onerror = (event) => resolve({ kind: "fault", reason: event.message });
    worker.postMessage(message);
  });
}
