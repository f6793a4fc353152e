// Bytes as text: thirteen bits in two characters, a twelfth shorter than base64. None of the characters has a meaning in a script element.

/** The values of the characters from # to ~ without <. */
const VALUES = new Uint8Array(128);
Array.from({ length: 92 }, (_, n) => String.fromCharCode(35 + n))
  .filter((letter) => letter !== "<")
  .forEach((letter, value) => (VALUES[letter.charCodeAt(0)] = value));

/** The bytes of whole pairs of characters; the last byte may be padding. */
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
