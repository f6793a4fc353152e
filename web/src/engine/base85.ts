// Bytes as text: four in five letters, which is less than base64. None of the letters means anything in HTML.

/** The letters from # to z without &, < and >, each with its value. */
const VALUES = new Uint8Array(128);
Array.from({ length: 88 }, (_, n) => String.fromCharCode(35 + n))
  .filter((letter) => !"&<>".includes(letter))
  .forEach((letter, value) => (VALUES[letter.charCodeAt(0)] = value));

/** Whole groups of five letters. */
export function bytes(text: string): Uint8Array<ArrayBuffer> {
  const made = new Uint8Array((text.length / 5) * 4);
  const view = new DataView(made.buffer);
  for (let at = 0, group = 0; at < made.length; at += 4, group += 5) {
    let value = 0;
    for (let n = 0; n < 5; n++) value = value * 85 + (VALUES[text.charCodeAt(group + n)] ?? 0);
    view.setUint32(at, value);
  }
  return made;
}
