// Results read as JSON.

import { type Answer, type Engine, text as decoded } from "../engine/engine.ts";
import { ask, type Command, extended } from "./command.ts";

/** A result, and its value if it has one. */
export interface Read<T> {
  readonly answer: Answer;
  readonly value: T | undefined;
}

/** Runs a query for JSON and reads the result. */
export async function read<T>(engine: Engine, command: Command, signal: AbortSignal, files?: ReadonlyMap<string, Uint8Array>): Promise<Read<T>> {
  const answer = await ask(engine, extended(command, { json: true }), files === undefined ? { signal } : { signal, files });
  return { answer, value: parsed<T>(decoded(answer)) };
}

/** The value of JSON; `undefined` for output that ended early. */
export function parsed<T>(written: string): T | undefined {
  try {
    return JSON.parse(written) as T;
  } catch {
    return undefined;
  }
}
