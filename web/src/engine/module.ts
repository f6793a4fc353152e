// WebAssembly modules that stand in the page: compressed by gzip, as base64 in a script element that nobody runs.

/** The module of an element with this id. */
export async function module(id: string): Promise<WebAssembly.Module> {
  return WebAssembly.compile(await decompressed(bytes(await element(id))));
}

/** The element, which may not have been read yet. */
async function element(id: string): Promise<string> {
  if (document.readyState === "loading") {
    const found = document.getElementById(id);
    // One that something stands behind is there as a whole.
    if (found?.nextElementSibling == null) {
      await new Promise((resolve) => document.addEventListener("DOMContentLoaded", resolve, { once: true }));
    }
  }
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page was built without the module ${id}`);
  return found.textContent;
}

function bytes(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
}

async function decompressed(compressed: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}
