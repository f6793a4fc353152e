// The messages between the page and its workers.

import type { QueryError } from "./engine.ts";

/** To a worker: first the module, as text or as compiled by an earlier worker, then queries, which may be cancelled, or motions and the times
    at which they are needed. */
export type ToWorker =
  | { readonly kind: "text"; readonly text: string }
  | { readonly kind: "module"; readonly module: WebAssembly.Module }
  | { readonly kind: "question"; readonly words: readonly string[]; readonly files: ReadonlyMap<string, Uint8Array> }
  | { readonly kind: "stop" }
  | { readonly kind: "ensemble"; readonly words: readonly string[]; readonly files: ReadonlyMap<string, Uint8Array> }
  | { readonly kind: "advance"; readonly time: number };

/** From a worker: the module for later workers; parts of an output, then its end; motions that have begun, and their states. */
export type FromWorker =
  | { readonly kind: "module"; readonly module: WebAssembly.Module }
  | { readonly kind: "output"; readonly chunk: Uint8Array }
  | { readonly kind: "note"; readonly line: string }
  | { readonly kind: "progress"; readonly howFar: string | undefined }
  | {
      readonly kind: "end";
      readonly status: number;
      readonly error: QueryError;
      readonly files: ReadonlyMap<string, Uint8Array>;
    }
  | { readonly kind: "begun"; readonly status: number; readonly error: QueryError; readonly numbers: Float64Array; readonly text: string }
  | { readonly kind: "states"; readonly states: Float64Array; readonly bodies: Float64Array; readonly ended: number; readonly cause: string }
  | { readonly kind: "fault"; readonly reason: string };
