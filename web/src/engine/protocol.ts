// What the page and its worker say to each other.

/** To the worker: first the module, as text or as a worker before has compiled it, then questions. */
export type ToWorker =
  | { readonly kind: "text"; readonly text: string }
  | { readonly kind: "module"; readonly module: WebAssembly.Module }
  | { readonly kind: "question"; readonly words: readonly string[]; readonly files: ReadonlyMap<string, Uint8Array> };

/** From the worker: the module for those after it; parts of an answer, then its end. */
export type FromWorker =
  | { readonly kind: "module"; readonly module: WebAssembly.Module }
  | { readonly kind: "output"; readonly chunk: Uint8Array }
  | { readonly kind: "note"; readonly line: string }
  | { readonly kind: "progress"; readonly howFar: string | undefined }
  | {
      readonly kind: "end";
      readonly status: number;
      readonly error: string;
      readonly files: ReadonlyMap<string, Uint8Array>;
    }
  | { readonly kind: "fault"; readonly reason: string };
