// Answers read as JSON.

import { type Answer, type Engine, text as decoded } from "../engine/engine.ts";
import { ask, type Command, extended } from "./command.ts";

/** An answer, and what it says where it says something. */
export interface Read<T> {
  readonly answer: Answer;
  readonly value: T | undefined;
}

/** Asks for JSON and reads it. */
export async function read<T>(engine: Engine, command: Command, signal: AbortSignal, files?: ReadonlyMap<string, Uint8Array>): Promise<Read<T>> {
  const answer = await ask(engine, extended(command, { json: true }), files === undefined ? { signal } : { signal, files });
  return { answer, value: parsed<T>(decoded(answer)) };
}

/** What ended early is no JSON. */
export function parsed<T>(written: string): T | undefined {
  try {
    return JSON.parse(written) as T;
  } catch {
    return undefined;
  }
}
