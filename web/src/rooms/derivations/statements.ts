// The statements of two published derivations, with the verdict on each.

import { element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";

const words = text.derivations;

/** The result of `libration paper`. */
export interface Paper {
  readonly equations: readonly Statement[];
}

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
export function statements({ equations }: Paper): Node[] {
  const sources = new Map(equations.map(({ document, read_from }) => [name(document), read_from]));
  return [
    element("p", { class: "good-to-know" }, words.found(equations.length, counted(equations))),
    ...Array.from(sources, ([document, source]) => element("p", { class: "quiet" }, words.readFrom(document, source))),
    ...equations.map(card),
  ];
}

function counted(equations: readonly Statement[]): string {
  const counts = new Map<string, number>();
  for (const { verdict } of equations) counts.set(kind(verdict), (counts.get(kind(verdict)) ?? 0) + 1);
  return Array.from(counts, ([verdict, count]) => `${count} ${verdict}`).join(", ");
}

function card(statement: Statement): HTMLElement {
  const { document, label, claim, printed, paraphrase, verdict, correct, evidence } = statement;
  const lines = (title: string, all: readonly (string | Node)[]) => [element("dt", {}, title), ...all.map((it) => element("dd", {}, it))];
  const code = (formula: string) => element("code", {}, formula);
  return element(
    "article",
    { class: `statement ${kind(verdict)}` },
    element("h2", {}, `${label}: ${claim}`),
    element("p", { class: "quiet" }, name(document)),
    element(
      "dl",
      {},
      ...lines(paraphrase ? words.ours : words.printed, printed.map(code)),
      ...lines(words.verdict, [element("strong", { class: "verdict" }, verdict)]),
      ...(correct === "" ? [] : lines(words.correct, [code(correct)])),
      ...lines(words.evidence, [evidence]),
    ),
  );
}

// The first word: "wrong above …" is wrong.
function kind(verdict: string): string {
  return verdict.startsWith("not") ? "not decided" : (verdict.split(" ")[0] ?? verdict);
}

function name(document: string): string {
  return document === "cote" || document === "black-vel" ? words.document[document] : document;
}
