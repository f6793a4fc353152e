// Sentences whose technical terms are explained where they stand.

import { button, element, identifier } from "./element.ts";
import { text } from "../texts/en.ts";

/** The sentence, in which each term in square brackets is a button that shows its explanation. */
export function explainedTerms(sentence: string): (Node | string)[] {
  return sentence.split(/(\[[^\]]+\])/).flatMap((part): (Node | string)[] => {
    const term = /^\[(.+)\]$/.exec(part)?.[1];
    const explanation = term === undefined ? undefined : text.parts.terms[term];
    if (term === undefined || explanation === undefined) return [part];
    const id = identifier();
    const shown = element("span", { popover: "auto", id, class: "explanation", role: "note" }, element("b", {}, term), ` ${explanation}`);
    return [button(term, () => {}, { class: "term", popovertarget: id }), shown];
  });
}
