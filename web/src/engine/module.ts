// WebAssembly modules that stand in the page: compressed, as text in a script element that nobody runs.

import { bytes } from "./base85.ts";
import { decompressed } from "./lzma.ts";

/** The text of the module in the element with this id, which may not have been read yet. */
export async function text(id: string): Promise<string> {
  if (document.readyState === "loading") {
    // One that something stands behind is there as a whole.
    if (document.getElementById(id)?.nextElementSibling == null) {
      await new Promise((resolve) => document.addEventListener("DOMContentLoaded", resolve, { once: true }));
    }
  }
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page was built without the module ${id}`);
  return found.textContent;
}

/** The module of such a text. */
export function compiled(text: string): Promise<WebAssembly.Module> {
  return WebAssembly.compile(decompressed(bytes(text)));
}
