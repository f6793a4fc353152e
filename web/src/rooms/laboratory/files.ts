// The files of the reader: dropped, chosen, or recorded. They stay in the memory of this page.

import { button, element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";

const words = text.laboratory;
/** Largest size of a file in bytes; the memory of a page may not suffice for more. */
const LARGEST = 200e6;

export class Files {
  readonly element: HTMLElement;
  readonly #held = new Map<string, Uint8Array>();
  readonly #list = element("ul", { class: "files" });
  readonly #failure = element("p", { class: "error", role: "alert", hidden: true });
  readonly #changed: () => void;

  constructor(changed: () => void) {
    this.#changed = changed;
    const input = element("input", { type: "file", multiple: true, id: "laboratory-files" });
    input.addEventListener("change", () => {
      void this.#take([...(input.files ?? [])]);
      input.value = "";
    });
    const label = element("label", { for: "laboratory-files" }, words.drop);
    this.element = element("div", { class: "drop" }, label, input, element("p", { class: "hint" }, words.kinds), this.#failure, this.#list);
    this.#listen();
  }

  /** The files, by name. */
  get all(): ReadonlyMap<string, Uint8Array> {
    return this.#held;
  }

  /** Adds a file under its name, or under a similar one if that is taken. */
  add(name: string, bytes: Uint8Array): void {
    this.#held.set(this.#free(name), bytes);
    this.#show();
    this.#changed();
  }

  #listen(): void {
    for (const kind of ["dragover", "dragleave", "drop"]) {
      this.element.addEventListener(kind, (event) => {
        event.preventDefault();
        this.element.classList.toggle("over", kind === "dragover");
      });
    }
    this.element.addEventListener("drop", (event) => void this.#take([...(event.dataTransfer?.files ?? [])]));
  }

  async #take(files: readonly File[]): Promise<void> {
    this.#fail("");
    for (const file of files) {
      if (file.size > LARGEST) this.#fail(words.tooLarge(file.name, (file.size / 1e6).toFixed(0)));
      else this.#held.set(this.#free(file.name), new Uint8Array(await file.arrayBuffer()));
    }
    this.#show();
    this.#changed();
  }

  // The command takes `-` for its standard input, and reports are written next to the files.
  #free(name: string): string {
    const plain = name.replace(/^-+/, "").replaceAll(/[/\\\0]/g, "_") || "file";
    let free = plain;
    for (let count = 2; this.#held.has(free) || free === "report.html"; count += 1) free = `${count}_${plain}`;
    return free;
  }

  #show(): void {
    const lines = Array.from(this.#held.keys(), (name) => {
      const remove = button("×", () => this.#remove(name), { "aria-label": words.remove(name) });
      return element("li", {}, element("span", { class: "mono" }, name), " ", remove);
    });
    this.#list.replaceChildren(...lines);
  }

  #remove(name: string): void {
    this.#held.delete(name);
    this.#show();
    this.#changed();
  }

  #fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
  }
}
