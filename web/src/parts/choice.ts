// A sentence with buttons, of which one is pressed.

import { button, element } from "./element.ts";

/** The sentence, followed by a button for each choice; the present one is pressed. */
export function choice(sentence: string, choices: readonly (readonly [label: string, isChosen: boolean, press: () => void])[]): HTMLElement {
  const buttons = choices.map(([label, isChosen, press]) => button(label, press, { class: "small", "aria-pressed": String(isChosen) }));
  return element("p", { class: "choice", role: "group", "aria-label": sentence }, element("span", {}, sentence), " ", ...buttons.flatMap((it) => [it, " "]));
}
