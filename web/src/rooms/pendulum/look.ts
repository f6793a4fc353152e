// A graph with a sentence that says what to look at, and a link to more.

import { element } from "../../parts/element.ts";
import { Plot } from "../../parts/plot.ts";
import { explainedTerms } from "../../parts/terms.ts";
import { text } from "../../texts/en.ts";

export function lookedAt(title: string, [sentence, room]: readonly [sentence: string, room: string], ...below: Node[]): Plot {
  const plot = new Plot(title, ...below);
  const more = element("a", { href: `#${room}`, "aria-label": `${text.parts.more}: ${title}` }, text.parts.more);
  plot.element.querySelector("figcaption")?.after(element("p", { class: "look" }, ...explainedTerms(sentence), " ", more));
  return plot;
}
