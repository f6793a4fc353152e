// The queries of the room, as lines that can be run elsewhere.

import { text } from "../texts/en.ts";
import { type Command, pythonLine, shellLine } from "./command.ts";
import { button, element } from "./element.ts";

/** The same queries as lines for a shell and for Python. */
export class Equivalents {
  readonly element: HTMLElement;
  readonly #shell = element("code");
  readonly #python = element("code");

  constructor() {
    this.element = element(
      "details",
      { class: "equivalents" },
      element("summary", {}, text.parts.equivalents),
      ...this.#block(text.parts.asCommand, this.#shell),
      ...this.#block(text.parts.inPython, this.#python),
    );
  }

  show(commands: readonly Command[]): void {
    this.#shell.textContent = commands.map(shellLine).join("\n");
    this.#python.textContent = ["from libration import questions", ...commands.map(pythonLine)].join("\n");
  }

  #block(title: string, code: HTMLElement): Node[] {
    return [element("h3", {}, title), element("pre", { tabindex: "0", "aria-label": title }, code), copyButton(() => code.textContent ?? "", title)];
  }
}

/** A button that copies a text; `what` describes the text for screen readers. */
export function copyButton(content: () => string, what: string): HTMLButtonElement {
  const made = button(text.parts.copy, async () => {
    made.textContent = (await copied(content())) ? text.parts.copied : text.parts.notCopied;
    setTimeout(() => (made.textContent = text.parts.copy), 2000);
  });
  made.setAttribute("aria-label", `${text.parts.copy}: ${what}`);
  return made;
}

// A page opened from a disk may have no clipboard; then the older method is used, by a selection.
async function copied(content: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(content);
    return true;
  } catch {
    const area = element("textarea", { class: "unseen" });
    area.value = content;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}
