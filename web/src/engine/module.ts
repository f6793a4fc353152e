// Compressed parts of the page, as text in script elements that are not executed: WebAssembly modules, and licences.

import { joined } from "./streams.ts";

/** The text of the element with this id, which may not have been parsed yet. */
export async function text(id: string): Promise<string> {
  if (document.readyState === "loading") {
    // An element with a following sibling is complete.
    if (document.getElementById(id)?.nextElementSibling == null) {
      await new Promise((resolve) => document.addEventListener("DOMContentLoaded", resolve, { once: true }));
    }
  }
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page was built without its part ${id}`);
  return found.textContent;
}

/** The decompressed content of the element with this id. */
export async function unpacked(id: string): Promise<string> {
  return new TextDecoder().decode(unpack(await text(id)));
}

/** The module of such a text. */
export function compiled(text: string): Promise<WebAssembly.Module> {
  return WebAssembly.compile(joined(unpack(text)));
}
