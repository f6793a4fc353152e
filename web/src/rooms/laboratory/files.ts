// The files of the reader: dropped, chosen, typed, or recorded. They stay in the memory of this page.

import { button, element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";
import { interval, lineCount, MOST_ROWS, thinned } from "./thinning.ts";

const words = text.laboratory;
/** Largest size of a file in bytes; the memory of a page may not suffice for more. */
const LARGEST = 200e6;
/** Files in which pictures are and no numbers. */
const PICTURES = /^(video|image)\/|\.(mp4|mov|avi|mkv|webm|m4v|jpe?g|png|heic)$/i;
const TYPED = "table.txt";

export class Files {
  readonly element: HTMLElement;
  readonly #held = new Map<string, Uint8Array>();
  /** Files with very many rows, by name, until the reader has decided about them. */
  readonly #long = new Map<string, number>();
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
    this.element = element("div", { class: "drop" }, label, input, element("p", { class: "hint" }, words.kinds), element("p", { class: "hint" }, words.noVideo), this.#failure, this.#list, this.#typing());
    this.#listen();
  }

  /** The files to read, by name. */
  get all(): ReadonlyMap<string, Uint8Array> {
    return new Map([...this.#held].filter(([name]) => !this.#long.has(name)));
  }

  /** Adds a file under its name, or under a similar one if that is taken. */
  add(name: string, bytes: Uint8Array): void {
    this.#put(this.#free(name), bytes);
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

  // A table that is typed, or pasted from a spreadsheet.
  #typing(): HTMLElement {
    const area = element("textarea", { id: "laboratory-typed", rows: "6", spellcheck: "false", placeholder: words.typed.example, class: "mono" });
    const use = () => {
      if (area.value.trim() === "") return;
      this.#put(TYPED, new TextEncoder().encode(`${area.value.trim()}\n`));
      this.#show();
      this.#changed();
    };
    return element("details", {}, element("summary", {}, words.typed.title), element("label", { for: area.id, class: "hint" }, words.typed.hint), area, element("p", { class: "buttons" }, button(words.typed.use, use)));
  }

  async #take(files: readonly File[]): Promise<void> {
    const failures: string[] = [];
    for (const file of files) {
      if (PICTURES.test(file.type) || PICTURES.test(file.name)) failures.push(words.picture(file.name));
      else if (file.size > LARGEST) failures.push(words.tooLarge(file.name, (file.size / 1e6).toFixed(0)));
      else this.#put(this.#free(file.name), new Uint8Array(await file.arrayBuffer()));
    }
    this.#fail(failures.join("\n"));
    this.#show();
    this.#changed();
  }

  #put(name: string, bytes: Uint8Array): void {
    const isText = !bytes.subarray(0, 1000).includes(0);
    const lines = isText ? lineCount(bytes) : 0;
    if (lines > MOST_ROWS) this.#long.set(name, lines);
    this.#held.set(name, bytes);
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
      return element("li", {}, element("span", { class: "mono" }, name), " ", remove, ...this.#offer(name));
    });
    this.#list.replaceChildren(...lines);
  }

  #offer(name: string): HTMLElement[] {
    const [lines, bytes] = [this.#long.get(name), this.#held.get(name)];
    if (lines === undefined || bytes === undefined) return [];
    const every = interval(lines);
    const decide = (kept: Uint8Array) => {
      this.#long.delete(name);
      this.#held.set(name, kept);
      this.#show();
      this.#changed();
    };
    const buttons = [button(words.thin.keep(every), () => decide(thinned(bytes, every)), { class: "main" }), button(words.thin.all, () => decide(bytes))];
    return [element("p", {}, words.thin.many(lines)), element("p", { class: "buttons" }, ...buttons)];
  }

  #remove(name: string): void {
    this.#held.delete(name);
    this.#long.delete(name);
    this.#show();
    this.#changed();
  }

  #fail(reason: string): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
  }
}
