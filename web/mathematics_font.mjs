// Letters and signs of formulas from a font with a MATH table, small enough for the page.
//
// Browsers draw roots and brackets as high as what they hold only with such a font, and not every system has one: without, √(g/ℓ) looks
// like √g over ℓ.

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import subset from "subset-font";

const FONT = "@fontsource/stix-two-math/files/stix-two-math-latin-400-normal.woff2";

const range = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => String.fromCodePoint(first + i)).join("");

/** Every sign that the font is to have. Single letters of formulas are drawn as the italic ones of mathematics. */
export const signs = [
  range(0x20, 0x7e),
  range(0x391, 0x3c9),
  "ϑϕϵℏℓ°·×÷±∓−′″‴…⋯∂∫∑∏√∞≈≔≠≡≤≥∝→⟨⟩‖¯ˉˆ˜˙¨½",
  range(0x1d434, 0x1d467),
  "ℎ",
  range(0x1d6e2, 0x1d71b),
  range(0x2070, 0x2099),
  "¹²³",
].join("");

/** The font as WOFF2, without hints, which are a quarter of it and help only coarse screens. */
export async function mathematicsFont() {
  const whole = readFileSync(createRequire(import.meta.url).resolve(FONT));
  return Buffer.from(await subset(whole, signs, { targetFormat: "woff2", noHinting: true }));
}
