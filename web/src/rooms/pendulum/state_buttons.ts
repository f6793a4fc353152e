// Undo, redo, reset, and the link to the present state.

import type { Address } from "../../address.ts";
import { button, element } from "../../parts/element.ts";
import { copyButton } from "../../parts/equivalents.ts";
import { icon } from "../../parts/icon.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.state;

export class StateButtons {
  readonly element: HTMLElement;
  readonly #end: () => void;

  constructor(address: Address) {
    const named = (name: "undo" | "redo", pressed: () => void) => {
      const made = button("", pressed, { class: "icon", "aria-label": words[name], title: words[name], "data-state": name });
      made.append(icon(name));
      return made;
    };
    const [undo, redo] = [named("undo", () => address.undo()), named("redo", () => address.redo())];
    const reset = button(words.reset, () => address.reset());
    const show = () => {
      undo.disabled = !address.history.canUndo;
      redo.disabled = !address.history.canRedo;
    };
    this.#end = address.history.watch(show);
    show();
    const embed = element("input", { type: "checkbox" });
    const copy = copyButton(() => linkTo(address, embed.checked), words.link);
    const link = element("details", { class: "fields" }, element("summary", {}, words.link), element("p", { class: "hint" }, location.protocol === "file:" ? words.local : words.hosted), element("label", {}, embed, ` ${words.embed}`), element("p", { class: "buttons" }, copy));
    this.element = element("div", { class: "state" }, element("p", { class: "buttons" }, undo, redo, reset), link);
  }

  close(): void {
    this.#end();
  }
}

/** The link: on a disk the state only, since the folder is of this machine. */
function linkTo(address: Address, isEmbedded: boolean): string {
  const fragment = address.fragment(isEmbedded ? "embed" : "pendulum");
  return location.protocol === "file:" ? fragment : `${location.href.split("#")[0]}${fragment}`;
}
