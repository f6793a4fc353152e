// Room 5: measurements are read, fitted and assessed, without leaving the machine.

import type { Address } from "../../address.ts";
import { type Answer, type Engine, text as decoded } from "../../engine/engine.ts";
import { read } from "../../parts/answers.ts";
import { ask, type Command, extended, given, reason } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { Equivalents } from "../../parts/equivalents.ts";
import type { Field } from "../../parts/field.ts";
import { Form } from "../../parts/form.ts";
import { Latest } from "../../parts/latest.ts";
import { Finding, layout } from "../../parts/layout.ts";
import { Picture } from "../../parts/picture.ts";
import { save, saveAnswer } from "../../parts/save.ts";
import { Status } from "../../parts/status.ts";
import { telling } from "../../parts/telling.ts";
import type { Room } from "../../room.ts";
import { text } from "../../texts/en.ts";
import { example } from "./example.ts";
import { fields, type Kind, optionOf, PARTS, taken } from "./fields.ts";
import { Files } from "./files.ts";
import { received } from "./handed.ts";
import { MotionSensor } from "./motion_sensor.ts";
import { type Inspection, kindOf, reading } from "./reading.ts";
import { report } from "./report.ts";

const words = text.laboratory;
const REPORT = "report.html";

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
  readonly #fields: readonly Field[] = fields();
  readonly #form: Form;
  readonly #files = new Files(() => this.#update());
  readonly #sensor = new MotionSensor((name, bytes) => this.#files.add(name, bytes));
  readonly #latest = new Latest();
  readonly #status = new Status(() => this.#latest.stop());
  readonly #read = new Finding(words.read);
  readonly #fit: Finding;
  readonly #picture: Picture;
  readonly #buttons: HTMLElement;
  readonly #saveReport = button(words.saveReport, () => this.#report !== undefined && save(REPORT, this.#report, "text/html"));
  readonly #equivalents = new Equivalents();
  #kind: Kind | undefined;
  #report: Uint8Array | undefined;

  constructor(address: Address, given: Engine) {
    const engine = telling(given, this.#status);
    [this.#address, this.#engine] = [address, engine];
    this.#form = new Form(address, this.#fields, () => this.#update());
    this.#picture = new Picture(engine, "fit");
    this.#buttons = this.#saving();
    this.#fit = new Finding(words.fit, this.#picture.element);
    this.#fit.element.firstElementChild?.after(this.#buttons);
    const tried = button(words.example, () => void this.#try());
    const { choices, apparatus, reading: how } = PARTS;
    const controls = [
      this.#files.element,
      element("p", { class: "buttons" }, tried),
      element("p", { class: "quiet" }, words.addressed),
      this.#sensor.element,
      this.#form.part(words.choices, ["kind", ...choices]),
      this.#form.part(words.apparatus, apparatus.filter((key) => !(choices as readonly string[]).includes(key)), { folded: true }),
      this.#form.part(words.reading, how.filter((key) => !(choices as readonly string[]).includes(key)), { folded: true }),
    ];
    const results = [this.#status.element, this.#read.element, this.#fit.element, this.#equivalents.element];
    const [title, lead, room] = layout(words.title, words.lead, controls, results) as [HTMLElement, HTMLElement, HTMLElement];
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

  #update(): void {
    this.#latest.run((signal) => this.#status.during(this.#answer(signal)));
  }

  async #answer(signal: AbortSignal): Promise<void> {
    this.#form.clear();
    this.#forget();
    if (this.#files.all.size === 0) {
      this.#read.show(element("p", { class: "quiet" }, words.nothing));
      this.#fit.element.hidden = true;
      return this.#offer();
    }
    const { isReadable, kind } = await this.#inspect(signal);
    if (signal.aborted) return;
    this.#kind = this.#chosen() ?? kind;
    this.#offer();
    this.#fit.element.hidden = !isReadable;
    if (!isReadable) return;
    if (this.#kind === undefined) return this.#fit.fail(words.whatToFit);
    await this.#fitted(this.#kind, signal);
  }

  #chosen(): Kind | undefined {
    const chosen = this.#form.value("kind");
    return chosen === "auto" ? undefined : (chosen as Kind);
  }

  // Inspects each file; the kind is that of the last file that determines one.
  async #inspect(signal: AbortSignal): Promise<{ isReadable: boolean; kind: Kind | undefined }> {
    let kind: Kind | undefined;
    let isReadable = false;
    const shown: HTMLElement[] = [];
    for (const [name, bytes] of this.#files.all) {
      const command = this.#inspection(name);
      const { answer, value } = await read<Inspection>(this.#engine, command, signal, new Map([[name, bytes]]));
      if (signal.aborted) return { isReadable, kind };
      if (value === undefined) {
        const failure = this.#form.blame(answer, taken("inspect")) || reason(answer);
        shown.push(element("article", { class: "reading" }, element("h3", { class: "mono" }, name), element("p", { class: "error" }, failure)));
        continue;
      }
      isReadable = true;
      kind = kindOf(value) ?? kind;
      shown.push(reading(name, value, this.#chosen() ?? kind, (option, choice) => this.#choose(option, choice), (option) => this.#go(option)));
    }
    this.#read.show(...shown);
    return { isReadable, kind };
  }

  async #fitted(kind: Kind, signal: AbortSignal): Promise<void> {
    const [command, files] = [this.#command(kind), this.#files.all];
    this.#equivalents.show([...Array.from(files.keys(), (name) => this.#inspection(name)), this.#asked(command, kind)]);
    const answer = await this.#answered(command, kind, signal);
    if (signal.aborted) return;
    if (answer.status !== 0) return this.#fit.fail(this.#form.blame(answer, taken(kind)) || reason(answer));
    const answered = element("pre", { tabindex: "0" }, decoded(answer));
    this.#buttons.hidden = false;
    this.#report = answer.files.get(REPORT);
    this.#saveReport.hidden = this.#report === undefined;
    if (this.#report !== undefined) {
      const inWords = element("details", {}, element("summary", {}, words.answer), answered);
      return this.#fit.show(report(new TextDecoder().decode(this.#report)), inWords);
    }
    this.#fit.show(answered);
    if (kind !== "response") await this.#picture.draw(command, signal, files);
  }

  // Fits of responses take so long that they run once, for text and picture.
  #answered(command: Command, kind: Kind, signal: AbortSignal): Promise<Answer> {
    const files = this.#files.all;
    if (kind === "response") return this.#picture.beside(command, signal, files);
    return ask(this.#engine, this.#asked(command, kind), { signal, files, onProgress: (howFar) => this.#status.say(howFar ?? "") });
  }

  #inspection(name: string): Command {
    return { question: "inspect", arguments: [name], options: this.#options(taken("inspect")) };
  }

  #command(kind: Kind): Command {
    const names = [...this.#files.all.keys()];
    return { question: `fit ${kind}`, arguments: kind === "trace" ? names : names.slice(0, 1), options: this.#options(taken(kind)) };
  }

  // Swings have a report; other fits have their results as text.
  #asked(command: Command, kind: Kind): Command {
    return kind === "trace" ? extended(command, { report: REPORT }) : command;
  }

  #options(keys: readonly string[]) {
    const ticks = new Set(["robust", "free-scale", "half-periods", "even-times", "times-as-written"]);
    return given(Object.fromEntries(keys.map((key) => [optionOf(key), ticks.has(key) ? this.#form.value(key) === "yes" : this.#form.value(key)])));
  }

  #offer(): void {
    const kind = this.#kind ?? "trace";
    for (const { key, element: field } of this.#fields) field.hidden = key !== "kind" && !taken(kind).includes(key) && !(this.#kind === undefined && taken("inspect").includes(key));
  }

  #choose(option: string, value: string): void {
    const field = this.#fields.find(({ key }) => optionOf(key) === option);
    if (field === undefined) return;
    this.#form.put(field.key, value);
    this.#update();
  }

  #go(option: string): void {
    const field = this.#fields.find(({ key }) => optionOf(key) === option);
    field?.element.closest("details")?.setAttribute("open", "");
    field?.element.querySelector<HTMLElement>("input, select")?.focus();
  }

  #forget(): void {
    this.#report = undefined;
    this.#buttons.hidden = true;
    this.#picture.clear();
  }

  #saving(): HTMLElement {
    const numbers = button(text.parts.saveData, () => void this.#save("csv", "fit.csv"));
    const answer = button(words.saveText, () => void this.#save(undefined, "fit.txt"));
    return element("p", { class: "buttons screen-only", hidden: true }, this.#saveReport, numbers, answer, button(words.print, () => print()));
  }

  async #save(form: "csv" | undefined, name: string): Promise<void> {
    if (this.#kind === undefined) return;
    const asked = form === undefined ? this.#command(this.#kind) : extended(this.#command(this.#kind), { [form]: true });
    const answer = await ask(this.#engine, asked, { files: this.#files.all });
    const failure = saveAnswer(name, answer, form === "csv" ? "text/csv" : "text/plain");
    if (failure !== "") this.#fit.fail(failure);
  }
}
