// The worker: holds the whole module, and runs one query after the other or advances motions from one time to the next.

import { NO_ERROR, type QueryError } from "./engine.ts";
import { instantiated } from "./fused.ts";
import { compiled } from "./module.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";
import { pause, waitedFor, waiting } from "./suspension.ts";
import { provideUnpack } from "./unpack.ts";

/** The exports of the module: buffers for the query, and the query itself. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  /** The address of a buffer for `length` bytes, which the next call of `argument` or `file` reads. */
  room(length: number): number;
  /** Takes the bytes in the buffer as the next word of the query. */
  argument(): void;
  /** Takes the bytes in the buffer as the name of a file, followed by its content. */
  file(nameLength: number): void;
  /** Runs the query with the words so far; returns the exit status. */
  ask(): Promise<number> | number;
  /** Begins the motions that the words so far describe; returns the exit status. */
  ensemble(): Promise<number> | number;
  /** Writes their states at a time as numbers, then the positions of their bodies. */
  advance(time: number): void;
  bodies(): void;
  /** Number of motions that have ended, with the first cause as text. */
  ended(): number;
  numbers(): number;
  numbers_count(): number;
  text(): number;
  text_length(): number;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();
const say = (message: FromWorker, transferred: ArrayBuffer[] = []) => postMessage(message, { transfer: transferred });

provideUnpack();

let exports: Promise<Exports>;
let error: QueryError = NO_ERROR;
let panic = "";
/** `true` if the query was cancelled. */
let isStopped = false;
let files = new Map<string, Uint8Array>();

onmessage = async ({ data }: MessageEvent<ToWorker>) => {
  try {
    if (data.kind === "text") exports = shared(data.text);
    else if (data.kind === "module") exports = begun(data.module);
    else if (data.kind === "stop") isStopped = true;
    else if (data.kind === "question") await answer(await exports, data.words, data.files);
    else if (data.kind === "ensemble") await begin(await exports, data.words, data.files);
    else advance(await exports, data.time);
  } catch (fault) {
    // The module's last message is more useful than the trap.
    say({ kind: "fault", reason: panic || (fault instanceof Error ? fault.message : String(fault)) });
  }
};

async function answer(module: Exports, words: readonly string[], given: ReadonlyMap<string, Uint8Array>): Promise<void> {
  files = new Map();
  give(module, words, given);
  const status = await module.ask();
  say({ kind: "end", status, error, files });
}

async function begin(module: Exports, words: readonly string[], given: ReadonlyMap<string, Uint8Array>): Promise<void> {
  give(module, words, given);
  const status = await module.ensemble();
  say({ kind: "begun", status, error, numbers: numbers(module), text: left(module) });
}

function advance(module: Exports, time: number): void {
  module.advance(time);
  const states = numbers(module);
  module.bodies();
  const bodies = numbers(module);
  const ended = module.ended();
  say({ kind: "states", states, bodies, ended, cause: ended > 0 ? left(module) : "" }, [states.buffer, bodies.buffer]);
}

function numbers(module: Exports): Float64Array<ArrayBuffer> {
  return new Float64Array(module.memory.buffer, module.numbers(), module.numbers_count()).slice();
}

function left(module: Exports): string {
  return decoder.decode(new Uint8Array(module.memory.buffer, module.text(), module.text_length()));
}

function give(module: Exports, words: readonly string[], given: ReadonlyMap<string, Uint8Array>): void {
  error = NO_ERROR;
  isStopped = false;
  for (const word of words) {
    put(module, encoder.encode(word));
    module.argument();
  }
  for (const [name, bytes] of given) {
    const encoded = encoder.encode(name);
    put(module, encoded, bytes);
    module.file(encoded.length);
  }
}

function put(module: Exports, ...parts: Uint8Array[]): void {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  let at = module.room(length);
  for (const part of parts) {
    new Uint8Array(module.memory.buffer, at, part.length).set(part);
    at += part.length;
  }
}

/** Passes the module on to the page, so that no other worker has to compile it. */
async function shared(text: string): Promise<Exports> {
  const module = await compiled(text);
  say({ kind: "module", module });
  return begun(module);
}

async function begun(module: WebAssembly.Module): Promise<Exports> {
  let memory: WebAssembly.Memory;
  const taken = (at: number, length: number) => new Uint8Array(memory.buffer, at, length).slice();
  const read = (at: number, length: number) => decoder.decode(taken(at, length));
  const page = {
    output: (at: number, length: number) => say({ kind: "output", chunk: taken(at, length) }),
    note: (at: number, length: number) => say({ kind: "note", line: read(at, length) }),
    // An empty text: that work has ended.
    progress: (at: number, length: number) =>
      say({ kind: "progress", howFar: length > 0 ? read(at, length) : undefined }),
    error: (at: number, length: number) => {
      error = JSON.parse(read(at, length)) as QueryError;
    },
    fault: (at: number, length: number) => {
      panic = read(at, length);
    },
    written: (name: number, nameLength: number, at: number, length: number) => {
      files.set(read(name, nameLength), taken(at, length));
    },
    goes_on: waitedFor(async () => {
      await pause();
      return isStopped ? 0 : 1;
    }, 1),
    milliseconds: () => Date.now(),
  };
  const exports = (await instantiated(module, { page })) as unknown as Exports;
  memory = exports.memory;
  return { ...exports, ask: waiting(exports.ask as () => number), ensemble: waiting(exports.ensemble as () => number) };
}
