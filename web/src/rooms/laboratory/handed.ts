// A file that another room hands to the laboratory. It stays in the memory of this page.

let handed: { readonly name: string; readonly bytes: Uint8Array } | undefined;

export function hand(name: string, bytes: Uint8Array): void {
  handed = { name, bytes };
}

/** The file, which is handed over once. */
export function received(): { readonly name: string; readonly bytes: Uint8Array } | undefined {
  const file = handed;
  handed = undefined;
  return file;
}
