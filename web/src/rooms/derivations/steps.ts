// A derivation as steps that open one after the other, with a link to each formula.

import { type Address, parsed, written } from "../../address.ts";
import { element } from "../../parts/element.ts";
import { withoutKeys } from "../../parts/in_words.ts";
import { fromHtml } from "../../parts/markup.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { text } from "../../texts/en.ts";

const words = text.derivations;

export class Steps {
  readonly element = element("div", { class: "derivation" });
  readonly #address: Address;
  readonly #judge: (answer: string) => Promise<Node[]>;

  constructor(address: Address, judge: (answer: string) => Promise<Node[]>) {
    this.#address = address;
    this.#judge = judge;
    this.element.addEventListener("click", (event) => this.#follow(event));
  }

  /** Shows a derivation written by the command as a page. */
  show(page: string): void {
    this.element.replaceChildren(...fromHtml(page).map(fitted));
    name(this.element);
    for (const formula of this.element.querySelectorAll(".to-answer")) formula.after(this.#answer(formula.querySelector(".number")?.textContent ?? ""));
    scrolling(...this.element.querySelectorAll(".wide, .formula, p"));
    for (const link of this.#links()) link.dataset["place"] = link.getAttribute("href")?.slice(1);
    const opened = this.#address.get("steps") ?? "1";
    this.#all().forEach((step, place) => (step.open = opened === "all" || place < Number(opened)));
    this.#arrive(this.#address.get("at"));
    this.#aim();
  }

  // A field for the answer to an exercise, which is judged below it.
  #answer(number: string): HTMLElement {
    const typed = element("input", { type: "text", "aria-label": words.answer.label(number), placeholder: words.answer.example, spellcheck: "false", autocapitalize: "off" });
    const said = element("div", { class: "judgement", role: "status" });
    const form = element("form", { class: "answer screen-only" }, typed, element("button", {}, words.answer.check), said);
    form.addEventListener("submit", async (event) => {
      event.preventDefault();
      if (typed.value.trim() !== "") said.replaceChildren(...(await this.#judge(`${number.replaceAll(/[()]/g, "")}=${typed.value}`)));
    });
    return form;
  }

  /** Opens the first step that is not open; returns `true` if there was one. */
  next(): boolean {
    const steps = this.#all();
    const place = steps.findIndex(({ open }) => !open);
    const step = steps[place];
    if (step === undefined) return false;
    step.open = true;
    this.#keep({ steps: String(place + 1) });
    step.scrollIntoView({ block: "start" });
    step.querySelector("summary")?.focus();
    return true;
  }

  setAll(open: boolean): void {
    for (const step of this.#all()) step.open = open;
    this.#keep({ steps: open ? "all" : "0", at: undefined });
  }

  #all(): HTMLDetailsElement[] {
    return [...this.element.querySelectorAll<HTMLDetailsElement>("details.step")];
  }

  #links(): HTMLAnchorElement[] {
    return [...this.element.querySelectorAll<HTMLAnchorElement>("a[href^='#']")];
  }

  #keep(values: Readonly<Record<string, string | undefined>>): void {
    this.#address.put(values);
    this.#aim();
  }

  // The fragment of the page is its address: a position in the text is a value of it, next to the reader's choices.
  #aim(): void {
    const { room, values } = parsed(location.hash);
    for (const link of this.#links()) {
      link.href = written(room, new Map([...values, ["at", link.dataset["place"] ?? ""]]));
      if (link.classList.contains("number")) link.setAttribute("aria-label", words.linkTo(link.textContent ?? ""));
    }
  }

  #follow(event: MouseEvent): void {
    const link = event.target instanceof Element ? event.target.closest("a") : null;
    const place = link?.dataset["place"];
    if (place === undefined || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    this.#keep({ at: place });
    this.#arrive(place);
  }

  #arrive(place: string | undefined): void {
    this.element.querySelector(".arrived")?.classList.remove("arrived");
    const found = place === undefined ? null : this.element.querySelector(`[id="${CSS.escape(place)}"]`);
    if (found === null) return;
    for (let step = found.closest("details"); step !== null; step = step.parentElement?.closest("details") ?? null) step.open = true;
    found.classList.add("arrived");
    found.scrollIntoView({ block: "center" });
  }
}

// Formulas that the text mentions have names instead of keys.
function name(place: Element): void {
  const walker = document.createTreeWalker(place, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    const { data } = node as Text;
    const named = withoutKeys(data);
    if (named !== data) (node as Text).data = named;
  }
}

// Makes sections foldable, and puts the titles of the text below that of the room.
function fitted(node: Node): Node {
  if (!(node instanceof HTMLElement)) return node;
  if (node.localName === "h1") return element("h2", { class: "title", id: node.id === "" ? undefined : node.id }, ...node.childNodes);
  return node.localName === "section" ? folded(node) : node;
}

// A section folded by its title.
function folded(section: HTMLElement): HTMLElement {
  const step = element("details", { class: "step", id: section.id });
  const title = section.querySelector("h2");
  // A title that folds the step cannot contain a link.
  title?.querySelectorAll("a").forEach((link) => link.replaceWith(...link.childNodes));
  step.append(element("summary", {}, title ?? words.answers), ...section.childNodes);
  return step;
}
