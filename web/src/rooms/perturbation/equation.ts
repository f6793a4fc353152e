// The LaTeX of a series: its equation, and its lines one by one.

import { fromLatex } from "../../parts/latex.ts";

/** The equation of motion, which is the first formula; `undefined` without one. */
export function equationOf(latex: string): Element | undefined {
  const first = formulas(latex)[0];
  return first === undefined ? undefined : fromLatex(first);
}

/** All formulas one below the other. */
export function typeset(latex: string): Element[] {
  return formulas(latex).map((formula) => fromLatex(formula));
}

function formulas(latex: string): string[] {
  const blocks = latex.match(/\\\[[^]*?\\\]|\\begin\{align\*\}[^]*?\\end\{align\*\}/g) ?? [];
  return blocks.flatMap((block) => block.replace(/^\\\[|\\\]$|\\(?:begin|end)\{align\*\}/g, "").split(/\\\\\s/)).map((line) => line.replaceAll("&", "").trim());
}
