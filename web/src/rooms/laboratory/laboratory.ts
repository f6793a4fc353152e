// Room 5: measurements are read, fitted and assessed, without leaving the machine.

import type { Address } from "../../address.ts";
import { type Answer, type Engine, text as decoded } from "../../engine/engine.ts";
import { parsed, read } from "../../parts/answers.ts";
import { choice } from "../../parts/choice.ts";
import { ask, type Command, extended, given } from "../../parts/command.ts";
import { explained, reason, unmarked } from "../../parts/marks.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import type { Field } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { NumbersTable } from "../../parts/numbers_table.ts";
import { save, saveAnswer } from "../../parts/save.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { example } from "./example.ts";
import { fields, type Key, type Kind, labelIn, optionOf, PARTS, ROLES, taken, valueOf } from "./fields.ts";
import { Files } from "./files.ts";
import { missing, step } from "./guide.ts";
import { received } from "./handed.ts";
import { type Fitted, reasons, results } from "./headline.ts";
import { possible } from "./kinds.ts";
import { MotionSensor } from "./motion_sensor.ts";
import { type Inspection, reading, undecided, unreadable, type ReadColumn } from "./reading.ts";
import { report } from "./report.ts";
import { advised, sentences, type Settings } from "./settings.ts";

const words = text.laboratory;
const REPORT = "report.html";

/** The files by what can be done with them, after their inspection. */
interface Found {
  readonly inspections: ReadonlyMap<string, Inspection>;
  /** The fits that the files allow, the most probable one first. */
  readonly kinds: readonly Kind[];
  readonly isClear: boolean;
}

export const laboratory: Room = {
  name: "laboratory",
  open(place, address, engine) {
    const room = new LaboratoryRoom(address, engine);
    place.append(...room.elements);
    room.begin();
    return () => room.leave();
  },
};

class LaboratoryRoom {
  readonly elements: readonly HTMLElement[];
  readonly #engine: Engine;
  readonly #address: Address;
  readonly #fields: readonly Field[] = fields((name) => labelIn(this.#kind ?? "inspect")(name));
  readonly #form: Form;
  readonly #files = new Files(() => this.#update());
  readonly #sensor = new MotionSensor((name, bytes) => this.#files.add(name, bytes));
  readonly #latest = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #read = new Finding(words.read);
  readonly #fit: Finding;
  readonly #story = element("div");
  readonly #numbers = new NumbersTable(async () => (this.#kind === undefined ? "" : decoded(await this.#tabled(this.#kind, "csv"))));
  readonly #buttons: HTMLElement;
  readonly #saveReport = button(words.saveReport, () => this.#report !== undefined && save(REPORT, this.#report, "text/html"));
  readonly #equivalents = new Equivalents();
  readonly #settings: Settings;
  #kind: Kind | undefined;
  #report: Uint8Array | undefined;
  #found: Found = { inspections: new Map(), kinds: [], isClear: false };
  /** The table that is fitted, of several. */
  #picked = "";

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    [this.#address, this.#engine] = [address, engine];
    this.#form = new Form(address, this.#fields, () => this.#update());
    this.#settings = { value: (key) => this.#form.value(key), put: (values) => this.#put(values) };
    this.#buttons = this.#saving();
    this.#fit = new Finding(words.fit, this.#numbers.element, this.#story, this.#buttons);
    const tried = button(words.example, () => void this.#try());
    const { choices, apparatus, reading: how } = PARTS;
    const giving = [this.#files.element, element("p", { class: "buttons" }, tried)];
    const controls = [
      element("p", { class: "quiet" }, words.addressed),
      this.#sensor.element,
      this.#form.part(words.choices, ["kind", ...choices]),
      this.#form.part(words.apparatus, apparatus.filter((key) => !choices.includes(key)), { folded: true }),
      this.#form.part(words.reading, how.filter((key) => !choices.includes(key)), { folded: true }),
    ];
    const results = [this.#status.element, this.#fit.element, this.#read.element, this.#equivalents.element];
    const [title, lead, room] = layout(words.title, words.lead, giving, results) as [HTMLElement, HTMLElement, HTMLElement];
    // On a narrow page the result stands between the files and the options.
    room.classList.add("laboratory");
    room.append(element("div", { class: "controls" }, ...controls));
    this.elements = [title, lead, element("p", { class: "stay" }, words.stay), room];
  }

  begin(): void {
    const file = received();
    if (file !== undefined) this.#files.add(file.name, file.bytes);
    else if (this.#address.get("example") !== undefined) void this.#try();
    else this.#update();
  }

  leave(): void {
    this.#latest.stop();
    this.#sensor.leave();
  }

  async #try(): Promise<void> {
    this.#address.put({ example: "yes" });
    const { name, bytes } = await this.#status.during(example(this.#engine));
    if (!this.#files.all.has(name)) this.#files.add(name, bytes);
  }

  #put(values: Readonly<Record<string, string>>): void {
    for (const [key, value] of Object.entries(values)) this.#form.put(key, value);
    this.#update();
  }

  #update(): void {
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    if (this.#files.all.size === 0) {
      this.#forget();
      this.#read.element.hidden = true;
      this.#fit.show(element("p", { class: "quiet" }, words.nothing));
      return this.#offer();
    }
    await this.#inspect(signal);
    if (signal.aborted) return;
    this.#read.element.hidden = false;
    this.#kind = this.#chosen() ?? (this.#found.isClear ? this.#found.kinds[0] : undefined);
    this.#offer();
    this.#fit.element.hidden = this.#found.inspections.size === 0;
    if (this.#kind === undefined || this.#fit.element.hidden) return this.#ask();
    await this.#fitted(this.#kind, signal);
  }

  // Asks for the kind of data, or what decides it.
  #ask(): void {
    this.#forget();
    const open = Array.from(this.#found.inspections, ([name, found]) => undecided(name, found, this.#settings)).flat();
    this.#fit.show(...this.#kinds(), ...open);
  }

  #chosen(): Kind | undefined {
    const chosen = this.#form.value("kind");
    return chosen === "auto" ? undefined : (chosen as Kind);
  }

  // Inspects each file; a file that cannot be read is reported and leaves the others as they are.
  async #inspect(signal: AbortSignal): Promise<void> {
    const inspections = new Map<string, Inspection>();
    const [refused, shown]: [HTMLElement[], HTMLElement[]] = [[], []];
    for (const [name, bytes] of this.#files.all) {
      const { answer, value } = await read<Inspection>(this.#engine, this.#inspection(name), signal, new Map([[name, bytes]]));
      if (signal.aborted) return;
      if (value === undefined) {
        this.#form.blame(answer, taken("inspect"));
        refused.push(unreadable(name, reason({ ...answer.error, subject: "" }), "inspect", this.#settings));
        continue;
      }
      inspections.set(name, value);
      shown.push(reading(name, value, (key) => this.#go(key)));
    }
    const all = Array.from(inspections.values(), possible);
    const clear = all.filter(({ isClear }) => isClear);
    this.#found = { inspections, isClear: clear.length > 0, kinds: [...new Set((clear.length > 0 ? clear : all).flatMap(({ kinds }) => kinds))] };
    this.#read.show(...refused, ...shown);
  }

  async #fitted(kind: Kind, signal: AbortSignal): Promise<void> {
    const files = this.#chosenFiles(kind);
    const command = this.#command(kind, [...files.keys()]);
    this.#equivalents.show([...Array.from(files.keys(), (name) => this.#inspection(name)), extended(command, { report: REPORT })]);
    const answer = await ask(this.#engine, extended(command, { report: REPORT, json: true }), { signal, files });
    if (signal.aborted) return;
    const it = answer.status === 0 ? parsed<Fitted>(decoded(answer)) : undefined;
    if (it === undefined) return this.#refuse(kind, answer);
    this.#buttons.hidden = false;
    this.#numbers.offer(true);
    this.#report = answer.files.get(REPORT);
    this.#saveReport.hidden = this.#report === undefined;
    this.#keepingFocus(() => this.#fit.show(...this.#headline(kind, it), ...this.#kinds(), ...this.#sentences(kind, it.read_columns ?? [])));
    this.#story.replaceChildren(...(this.#report === undefined ? [] : [report(new TextDecoder().decode(this.#report), kind)]), this.#inWords(command, files));
  }

  #headline(kind: Kind, it: Fitted): HTMLElement[] {
    const [first = words.result.none, ...others] = results(kind, it);
    const warnings = (it.warnings ?? []).map((warning) => element("li", { class: "doubt" }, ...advised(warning, kind, this.#settings)));
    const left = this.#leftOut(kind).map((name) => element("li", {}, words.leftOut(name)));
    const why = reasons(kind, it).map((sentence) => element("li", {}, sentence));
    const lacking = missing(kind, it, (key) => this.#form.value(key));
    return [
      element("p", { class: "result-headline" }, first),
      ...(others.length > 0 ? [element("ul", { class: "others" }, ...others.map((other) => element("li", {}, other)))] : []),
      element("ul", { class: "reasons" }, ...warnings, ...why, ...left),
      ...(lacking === undefined ? [] : [step(lacking, kind, "", this.#settings)]),
    ];
  }

  #refuse(kind: Kind, answer: Answer): void {
    this.#forget();
    const [name = ""] = this.#chosenFiles(kind).keys();
    const { subject } = answer.error;
    const failure = this.#form.blame({ ...answer, error: { ...answer.error, subject: subject === name ? "" : subject } }, taken(kind));
    const read = this.#found.inspections.get(name)?.table_columns ?? [];
    const wanted = ["length", "amplitude", "period"].map((key) => key as "length" | "amplitude" | "period").find((key) => answer.error.parameters.includes(`--${key}`) && this.#form.value(key) !== "");
    const open = kind === "trace" || kind === "gates" ? Array.from(this.#found.inspections, ([it, found]) => undecided(it, found, this.#settings)).flat() : [];
    this.#keepingFocus(() =>
      this.#fit.show(
        ...(failure === "" && wanted !== undefined ? [] : [element("p", { class: "error", role: "alert" }, ...(failure === "" ? [text.parts.seeField] : advised(failure, kind, this.#settings)))]),
        ...(wanted === undefined ? [] : [step(wanted, kind, explained(answer.error), this.#settings)]),
        ...this.#kinds(),
        ...open,
        ...this.#sentences(kind, read),
      ),
    );
  }

  // The fits that the files allow, by what they give, and the files between which a fit has to choose.
  #kinds(): HTMLElement[] {
    const { kinds, inspections, isClear } = this.#found;
    const [now, all] = [this.#kind, this.#kind === undefined || kinds.includes(this.#kind) ? kinds : [this.#kind, ...kinds]];
    const gives = all.map((kind) => [words.gives[kind], kind === now, () => this.#put({ kind: kind === kinds[0] && isClear ? "auto" : kind })] as const);
    const tables = now === undefined || now === "trace" ? [] : this.#candidates(now);
    return [
      ...(all.length > 1 ? [choice(now === undefined ? words.whatToFit : words.whatElse, gives)] : []),
      ...(inspections.size > 1 && tables.length > 1 ? [choice(words.whichFile, tables.map((name) => [name, this.#chosenFiles(now as Kind).has(name), () => this.#pick(name)]))] : []),
    ];
  }

  #sentences(kind: Kind, columns: readonly ReadColumn[]): HTMLElement[] {
    const [name = ""] = this.#chosenFiles(kind).keys();
    return sentences(kind, columns, this.#found.inspections.get(name)?.sheets[0]?.columns ?? [], this.#settings);
  }

  #pick(name: string): void {
    this.#picked = name;
    this.#update();
  }

  // The files that suit a fit, or all that can be read if none is known to suit.
  #candidates(kind: Kind): string[] {
    const readable = [...this.#found.inspections];
    const suitable = readable.filter(([, found]) => {
      const { kinds, isClear } = possible(found);
      return isClear && kinds.includes(kind);
    });
    return (suitable.length > 0 ? suitable : readable).map(([name]) => name);
  }

  // All recordings of one pendulum, or one table.
  #chosenFiles(kind: Kind): ReadonlyMap<string, Uint8Array> {
    const names = this.#candidates(kind);
    const chosen = kind === "trace" ? names : [names.find((name) => name === this.#picked) ?? names[0] ?? ""];
    return new Map([...this.#files.all].filter(([name]) => chosen.includes(name)));
  }

  #leftOut(kind: Kind): string[] {
    return kind === "trace" ? [...this.#found.inspections.keys()].filter((name) => !this.#chosenFiles(kind).has(name)) : [];
  }

  // The results as text are computed when they are opened.
  #inWords(command: Command, files: ReadonlyMap<string, Uint8Array>): HTMLElement {
    const shown = element("pre", { tabindex: "0" });
    const details = element("details", { class: "in-words" }, element("summary", {}, words.answer), shown);
    details.addEventListener("toggle", async () => {
      if (details.open && shown.textContent === "") shown.textContent = unmarked(decoded(await this.#status.during(ask(this.#engine, command, { files }))));
    });
    return details;
  }

  // A button that is shown again after a press keeps the focus.
  #keepingFocus(show: () => void): void {
    const focused = document.activeElement;
    const label = focused instanceof HTMLButtonElement && this.#fit.element.contains(focused) ? focused.textContent : null;
    show();
    if (label === null) return;
    const again = [...this.#fit.element.querySelectorAll("button")].find((it) => it.textContent === label);
    if (again !== undefined) again.focus();
    else {
      this.#fit.element.tabIndex = -1;
      this.#fit.element.focus();
    }
  }

  #inspection(name: string): Command {
    return { question: "inspect", arguments: [name], options: this.#options(taken("inspect")) };
  }

  #command(kind: Kind, names: readonly string[]): Command {
    const roles = this.#form.value(ROLES).split(",").filter((it) => it !== "");
    const options = [...this.#options(taken(kind)), ...(taken(kind).includes("columns") ? roles.map((role) => ["role", role] as const) : [])];
    return { question: `fit ${kind}`, arguments: names, options };
  }

  #options(keys: readonly Key[]) {
    return given(Object.fromEntries(keys.map((key) => [optionOf(key), valueOf(key, this.#form.value(key))])));
  }

  #offer(): void {
    const kind = this.#kind ?? "trace";
    for (const { key, element: field } of this.#fields) field.hidden = key !== "kind" && !taken(kind).includes(key as Key) && !(this.#kind === undefined && taken("inspect").includes(key as Key));
  }

  #go(key: Key): void {
    const field = this.#fields.find((it) => it.key === key);
    field?.element.closest("details")?.setAttribute("open", "");
    field?.element.querySelector<HTMLElement>("input, select")?.focus();
  }

  #forget(): void {
    this.#report = undefined;
    this.#buttons.hidden = true;
    this.#numbers.offer(false);
    this.#story.replaceChildren();
  }

  #saving(): HTMLElement {
    const numbers = button(text.parts.saveData, () => void this.#save("csv", "fit.csv"));
    const answer = button(words.saveText, () => void this.#save(undefined, "fit.txt"));
    return element("p", { class: "buttons screen-only", hidden: true }, this.#saveReport, numbers, answer, button(words.print, () => print()));
  }

  async #save(form: "csv" | undefined, name: string): Promise<void> {
    if (this.#kind === undefined) return;
    const failure = saveAnswer(name, await this.#tabled(this.#kind, form), form === "csv" ? "text/csv" : "text/plain");
    if (failure !== "") this.#fit.fail(failure);
  }

  #tabled(kind: Kind, form: "csv" | undefined): Promise<Answer> {
    const files = this.#chosenFiles(kind);
    const command = this.#command(kind, [...files.keys()]);
    return ask(this.#engine, form === undefined ? command : extended(command, { [form]: true }), { files });
  }
}
