// Sentences of the command about the domain and the source of a formula, with their plain formulas as mathematics.

import { fromLatex } from "../../parts/latex.ts";

/** Plain formulas, each with its LaTeX. */
const FORMULAS: readonly (readonly [plain: RegExp, latex: string])[] = [
  [/\(pi - amplitude\)\^\((-\d+\/\d+)\)/, "(\\pi-\\theta_0)^{$1}"],
  [/\b(\d+) sqrt (\d+)\b/, "$1\\sqrt{$2}"],
  [/\bpi\/(\d+)\b/, "\\pi/$1"],
  [/\bamplitude - amplitude\^3\/6\b/, "\\theta_0-\\theta_0^3/6"],
  [/\blambda\b/, "\\lambda"],
  [/\b1e(-?\d+)\b/, "10^{$1}"],
];

export function withMathematics(sentence: string): (Node | string)[] {
  const [first] = FORMULAS.flatMap(([plain, latex]) => {
    const found = plain.exec(sentence);
    return found === null ? [] : [{ index: found.index, plain: found[0], latex: found[0].replace(plain, latex) }];
  }).sort((a, b) => a.index - b.index);
  if (first === undefined) return [sentence.replaceAll(" degrees", "°")];
  const [before, after] = [sentence.slice(0, first.index), sentence.slice(first.index + first.plain.length)];
  return [before.replaceAll(" degrees", "°"), fromLatex(first.latex, false), ...withMathematics(after)];
}
