// Files that the page gives to the reader.

/** Offers bytes or text as a file with this name. */
export function save(name: string, content: Uint8Array | string, type: string): void {
  const place = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = place;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(place), 10_000);
}
