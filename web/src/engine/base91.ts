// Bytes as text: thirteen bits in two letters, which is a twelfth less than base64. The letters mean nothing in a script element.

/** The letters from # to ~ without <, each with its value. */
const VALUES = new Uint8Array(128);
Array.from({ length: 92 }, (_, n) => String.fromCharCode(35 + n))
  .filter((letter) => letter !== "<")
  .forEach((letter, value) => (VALUES[letter.charCodeAt(0)] = value));

/** The bytes of whole pairs of letters; the last may be one that only fills them. */
export function bytes(text: string): Uint8Array<ArrayBuffer> {
  const made = new Uint8Array(Math.floor((text.length / 2) * 13 / 8));
  let kept = 0;
  let bits = 0;
  for (let at = 0, pair = 0; at < made.length; pair += 2) {
    const value = (VALUES[text.charCodeAt(pair)] ?? 0) * 91 + (VALUES[text.charCodeAt(pair + 1)] ?? 0);
    kept = (kept << 13) | value;
    for (bits += 13; bits >= 8 && at < made.length; at++) {
      bits -= 8;
      made[at] = kept >>> bits;
    }
    kept &= (1 << bits) - 1;
  }
  return made;
}
