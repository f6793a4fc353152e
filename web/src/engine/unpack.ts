// Decompression, once for each thread: the browser has compiled it for the program when the modules need it.

import { bytes } from "./base94.ts";
import { decompressed } from "./lzma.ts";

declare global {
  /** Decompresses a part of the page. */
  var unpack: (text: string) => Uint8Array<ArrayBuffer>;
}

/** Makes `unpack` known to the scripts of this thread. */
export function provideUnpack(): void {
  globalThis.unpack = (text) => decompressed(bytes(text));
}
