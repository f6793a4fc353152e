// The table of trials: filled by the instruments, typed, or pasted from a spreadsheet; drawn and fitted.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import { button, element } from "../../parts/element.ts";
import { type Field, textField } from "../../parts/field.ts";
import { digits } from "../../parts/numbers.ts";
import { hand } from "../laboratory/handed.ts";
import { text } from "../../texts/en.ts";
import { FIXED, MOST_READINGS, MOST_TRIALS, numberOf, Trials } from "./trials.ts";
import { type Fit, fitOf, fitted } from "./trials_fit.ts";
import { type Laws, meanPeriod, TrialsPlots } from "./trials_plots.ts";

const words = text.pendulum.trials;

export class TrialsTable {
  readonly element: HTMLElement;
  readonly #engine: Engine;
  readonly #trials: Trials;
  readonly #plots: TrialsPlots;
  readonly #laws: () => Laws;
  readonly #table = element("table");
  readonly #result = element("div", { class: "result", role: "status" });
  readonly #lengthError: Field = textField({ key: "lengthError", words: { label: words.lengthError }, initial: "1", unit: "mm" });
  readonly #timeError: Field = textField({ key: "timeError", words: { label: words.timeError }, unit: "s" });
  readonly #name: Field = textField({ key: "name", words: { label: words.columnName } });
  #abort = new AbortController();

  constructor(address: Address, engine: Engine, laws: () => Laws) {
    [this.#engine, this.#laws] = [engine, laws];
    this.#trials = new Trials(address);
    this.#plots = new TrialsPlots(engine);
    const named = button(words.addColumn, () => this.#addColumn());
    const buttons = element("p", { class: "buttons" }, button(words.addReading, () => this.#change(() => this.#trials.addReading())), button(words.clear, () => this.#change(() => this.#trials.clear())));
    const adding = element("div", { class: "adding" }, this.#name.element, named);
    const fitting = element("div", { class: "adding" }, this.#lengthError.element, this.#timeError.element, button(words.fit, () => void this.#fit(), { class: "main" }));
    this.element = element("section", { class: "trials" }, element("h2", {}, words.title), element("p", { class: "quiet" }, words.lead), element("div", {}, element("div", { class: "scroll" }, this.#table), buttons, adding, fitting, this.#result), this.#plots.element);
    this.#table.addEventListener("paste", (event) => this.#paste(event));
    this.#show();
  }

  /** Adds a measured time with the settings of the bench; returns the number of trials. */
  add(amplitude: string, length: string, swings: number, seconds: string): number {
    this.#change(() => this.#trials.add(amplitude, length, swings, seconds));
    return this.#trials.all.length;
  }

  /** Draws the laws of the present settings. */
  update(): void {
    void this.#plots.show(this.#trials.all, this.#laws());
  }

  redraw(): void {
    this.#plots.redraw();
  }

  close(): void {
    this.#abort.abort();
    this.#plots.close();
  }

  #change(change: () => void): void {
    change();
    this.#trials.keep();
    this.#result.replaceChildren();
    this.#show();
  }

  #addColumn(): void {
    const name = this.#name.value;
    if (name === "") return this.#name.refuse(words.nameFirst);
    this.#name.refuse("");
    this.#name.value = "";
    this.#change(() => this.#trials.addColumn(name));
  }

  get #heads(): string[] {
    const { readings, names } = this.#trials;
    return [...words.fixed, ...Array.from({ length: readings }, (_, n) => words.reading(n + 1)), ...names];
  }

  #show(): void {
    const heads = this.#heads;
    const head = element("tr", {}, ...[...heads, words.period].map((name) => element("th", { scope: "col" }, name)));
    const rows = [...this.#trials.rows, []].map((row, down) => this.#row(row, down, heads));
    this.#table.replaceChildren(element("caption", {}, words.caption(this.#trials.all.length)), element("thead", {}, head), element("tbody", {}, ...rows));
    this.update();
  }

  #row(row: readonly string[], down: number, heads: readonly string[]): HTMLElement {
    const period = element("td", { class: "number" });
    const cells = heads.map((name, across) => {
      const input = element("input", { type: "text", autocomplete: "off", "aria-label": words.cell(name, down + 1), ...(across < FIXED + this.#trials.readings && { inputmode: "decimal" }) });
      input.value = row[across] ?? "";
      input.dataset["cell"] = `${down},${across}`;
      input.addEventListener("input", () => this.#enter(input, down, across, period));
      this.#judge(input, across);
      return element("td", {}, input);
    });
    this.#showPeriod(period, row);
    return element("tr", {}, ...cells, period);
  }

  #enter(input: HTMLInputElement, down: number, across: number, period: HTMLElement): void {
    const isNew = down >= this.#trials.rows.length;
    this.#trials.set(down, across, input.value);
    this.#trials.keep();
    this.#result.replaceChildren();
    this.#judge(input, across);
    this.#showPeriod(period, this.#trials.rows[down] ?? []);
    const caption = this.#table.querySelector("caption");
    if (caption !== null) caption.textContent = words.caption(this.#trials.all.length);
    if (isNew) this.#table.querySelector("tbody")?.append(this.#row([], this.#trials.rows.length, this.#heads));
    this.update();
  }

  /** Marks what should be a number and is none. */
  #judge(input: HTMLInputElement, across: number): void {
    const isWrong = across < FIXED + this.#trials.readings && input.value.trim() !== "" && !Number.isFinite(numberOf(input.value));
    if (isWrong) input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }

  #showPeriod(place: HTMLElement, row: readonly string[]): void {
    const trial = this.#trials.trial(row);
    place.textContent = trial === undefined ? "" : digits(meanPeriod(trial), 5);
  }

  #paste(event: ClipboardEvent): void {
    const [pasted, target] = [event.clipboardData?.getData("text/plain") ?? "", event.target as HTMLElement];
    const [down, across] = (target.dataset["cell"] ?? "").split(",").map(Number);
    if (!/[\t\n;]/.test(pasted.trim()) || down === undefined || across === undefined) return;
    event.preventDefault();
    let lines: number | undefined;
    this.#change(() => (lines = this.#trials.paste(pasted, down, across)));
    if (lines === undefined) this.#fail(words.tooLong(MOST_TRIALS, MOST_READINGS));
    else if (lines === 0) this.#fail(words.noNumbers);
    this.#table.querySelector<HTMLElement>(`[data-cell="${down},${across}"]`)?.focus();
  }

  async #fit(): Promise<void> {
    this.#abort.abort();
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    const wrong = this.#table.querySelector<HTMLInputElement>("[aria-invalid]");
    if (wrong !== null) return this.#fail(words.notNumber(wrong.getAttribute("aria-label") ?? "", wrong.value));
    const [millimetres, seconds] = [numberOf(this.#lengthError.value), numberOf(this.#timeError.value)];
    this.#lengthError.refuse(millimetres > 0 ? "" : words.positive);
    const isKnown = this.#timeError.value !== "";
    this.#timeError.refuse(!isKnown || seconds > 0 ? "" : words.positive);
    if (!(millimetres > 0) || (isKnown && !(seconds > 0))) return;
    const fit = fitOf(this.#trials.all, millimetres / 1000, isKnown ? seconds : undefined);
    if (typeof fit === "string") return this.#fail(fit);
    this.#result.replaceChildren(element("p", { class: "quiet" }, text.parts.computing));
    const found = await fitted(this.#engine, fit, Math.abs(this.#laws().gravity - 9.8) < 0.1, signal);
    if (signal.aborted) return;
    if (typeof found === "string") return this.#fail(found);
    const reasons = element("ul", {}, ...(fit.leftOut === 0 ? [] : [words.leftOut(fit.leftOut)]).concat(found.reasons).map((reason) => element("li", {}, reason)));
    this.#result.replaceChildren(element("p", { class: "headline" }, found.headline), reasons, this.#toLaboratory(fit));
  }

  #toLaboratory({ name, bytes, command }: Fit): HTMLElement {
    const link = new URLSearchParams([["kind", command.question.replace("fit ", "")], ...(command.options ?? []).map(([key, value]) => [key, String(value)])]);
    return element("p", {}, button(words.laboratory, () => {
      hand(name, bytes);
      location.hash = `#laboratory?${link.toString().replaceAll("+", "%20")}`;
    }));
  }

  #fail(reason: string): void {
    this.#result.replaceChildren(element("p", { class: "error" }, reason));
  }
}
