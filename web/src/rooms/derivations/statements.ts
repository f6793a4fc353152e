// The statements of two published derivations, with the verdict on each.

import { element } from "../../parts/element.ts";
import { fromLatex } from "../../parts/latex.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { text } from "../../texts/en.ts";
import { latexOf } from "./infix.ts";

const words = text.derivations;

/** The result of `libration paper`. */
export interface Paper {
  readonly equations: readonly Statement[];
}

type Verdict = "verified" | "typo" | "wrong" | "not-decided";

interface Statement {
  readonly document: string;
  readonly label: string;
  readonly claim: string;
  readonly printed: readonly string[];
  readonly paraphrase: boolean;
  readonly read_from: string;
  readonly verdict: string;
  readonly correct: string;
  readonly evidence: string;
}

/** All statements: the number with each verdict, then one after the other. */
export function statements({ equations }: Paper, said: (sentence: string) => string): Node[] {
  const sources = new Map(equations.map(({ document, read_from }) => [name(document), read_from]));
  return [
    element("p", { class: "good-to-know" }, words.found(equations.length, counted(equations))),
    ...Array.from(sources, ([document, source]) => element("p", { class: "quiet" }, words.readFrom(document, source))),
    ...equations.map((it) => card(it, said)),
  ];
}

function counted(equations: readonly Statement[]): string {
  const counts = new Map<Verdict, number>();
  for (const { verdict } of equations) counts.set(kind(verdict), (counts.get(kind(verdict)) ?? 0) + 1);
  return Array.from(counts, ([verdict, count]) => `${count} ${words.only[verdict]}`).join(", ");
}

function card(statement: Statement, said: (sentence: string) => string): HTMLElement {
  const { document, label, claim, printed, paraphrase, verdict, correct, evidence } = statement;
  const lines = (title: string, all: readonly (string | Node)[]) => [element("dt", {}, title), ...all.map((it) => element("dd", {}, it))];
  return element(
    "article",
    { class: `statement ${kind(verdict)}` },
    element("h2", {}, `${label}: ${claim}`),
    element("p", { class: "quiet" }, name(document)),
    element(
      "dl",
      {},
      ...lines(paraphrase ? words.ours : words.printed, printed.map(formulaOf)),
      ...lines(words.verdict, [element("strong", { class: "verdict" }, verdict)]),
      ...(correct === "" ? [] : lines(words.correct, [formulaOf(correct)])),
      ...lines(words.evidence, [spoken(said(evidence))]),
    ),
  );
}

// The first word: "wrong above …" is wrong.
function kind(verdict: string): Verdict {
  return (["verified", "typo", "wrong"] as const).find((it) => verdict.startsWith(it)) ?? "not-decided";
}

// Keys of formulas that have no other name are read as words.
function spoken(sentence: string): string {
  return sentence.replace(/(?<=\b[a-z]{2,})_(?=[a-z0-9])/g, " ");
}

/** A formula as mathematics, or as it is written if it is none. */
function formulaOf(written: string): Element {
  const latex = latexOf(written);
  if (latex === undefined) return element("code", {}, written);
  const place = element("div", { class: "scroll" }, fromLatex(latex));
  scrolling(place);
  return place;
}

function name(document: string): string {
  return document === "cote" || document === "black-vel" ? words.document[document] : document;
}
