// The part of the room for ensembles: its fields, buttons, pictures and words.

import type { Address } from "../../../address.ts";
import { type Engine, plainError, type QueryError } from "../../../engine/engine.ts";
import type { Command } from "../../../parts/command.ts";
import { button, element } from "../../../parts/element.ts";
import { choiceField, textField } from "../../../parts/field.ts";
import { Form } from "../../../parts/form.ts";
import { digits } from "../../../parts/numbers.ts";
import { NumbersTable } from "../../../parts/numbers_table.ts";
import { plainly } from "../../../parts/plain.ts";
import { save } from "../../../parts/save.ts";
import { text } from "../../../texts/en.ts";
import { CHECKED, CLOSE, Fleet, type Frame } from "./fleet.ts";
import { Growth } from "./growth.ts";
import { painted } from "./painted.ts";
import { axes, Plane } from "./plane.ts";
import { Player } from "./player.ts";
import { Stage } from "./stage.ts";
import { FILE, question, table } from "./starts.ts";

const words = text.chaos.fleet;
const MOST = 20_000;
/** Shortest time between changes of the words, in milliseconds, so that they can be read. */
const READABLE = 500;

export class FleetPanel {
  readonly element: HTMLElement;
  readonly fields: HTMLElement;
  readonly #engine: Engine;
  readonly #address: Address;
  readonly #changed: () => void;
  readonly #form: Form;
  readonly #stage = new Stage(words.bodies);
  readonly #plane = new Plane(words.plane);
  readonly #stroboscope = new Plane(words.stroboscope);
  readonly #growth = new Growth(words.growth, words.growthAxes, legend());
  readonly #run = button(words.run, () => this.#toggle(), { class: "main run" });
  readonly #words = element("p", { class: "fleet-words" });
  readonly #table = new NumbersTable(async () => this.#states());
  readonly #status = element("p", { role: "status", class: "quiet" });
  readonly #failure = element("p", { class: "error", role: "alert", hidden: true });
  readonly #moving: HTMLElement;
  #asked: { readonly system: Command; readonly starts: readonly string[] } | undefined;
  #begun = "";
  #number = 0;
  #rows = "";
  #player: Player | undefined;
  #fleet: Fleet | undefined;
  #frame: Frame | undefined;
  #first = 0;
  /** The time at which the error came close to the spread of the ensemble. */
  #trustEnds: number | undefined;
  #read = 0;
  #pace = "";

  /** `above` stands above the pictures; `changed` is called when the equivalent command has changed. */
  constructor(address: Address, engine: Engine, above: HTMLElement, changed: () => void) {
    [this.#address, this.#engine, this.#changed] = [address, engine, changed];
    const field = (key: "motions" | "tolerance", initial: string) => plainly(textField({ key, option: `--${key}`, words: words[key], initial }));
    const speed = choiceField({ key: "fleet-speed", words: { label: words.speed }, initial: "1" }, words.speeds.map(([value, name]) => [value, name] as const));
    this.#form = new Form(address, [field("motions", "2000"), field("tolerance", "1e-8"), speed], () => this.#update());
    this.fields = this.#form.part(words.fields, ["motions", "tolerance"]);
    speed.onChange(() => this.#setSpeed());
    const transport = element("div", { class: "transport", role: "group", "aria-label": words.group }, this.#run, button(words.restart, () => this.#restart()), button(words.step, () => void this.#step()), speed.element);
    const pictures = element("div", { class: "fleet-pictures" }, this.#stage.element, this.#stroboscope.plot.element, this.#plane.plot.element, this.#growth.plot.element);
    const saves = element("p", { class: "buttons screen-only" }, button(words.savePicture, () => void this.#savePicture()), button(words.saveStates, () => this.#saveStates()), button(words.saveStarts, () => save(FILE, this.#rows, "text/csv")));
    this.#moving = element("div", { hidden: true }, transport, above, pictures, this.#words, this.#table.element, saves);
    this.element = element("section", { class: "fleet" }, element("h2", {}, words.title), element("p", { class: "lead" }, words.lead), this.#failure, this.#status, this.#moving);
  }

  /** Shows the ensemble of this system between the first two of these initial states, if it is another one. */
  show(system: Command, starts: readonly string[]): void {
    this.#asked = { system, starts };
    this.#update();
  }

  /** Removes the ensemble, because the query of the room has no result. */
  clear(): void {
    this.#asked = undefined;
    this.#end();
    this.#fail("");
  }

  close(): void {
    this.#end();
    this.#stage.close();
    for (const { plot } of [this.#plane, this.#stroboscope, this.#growth]) plot.close();
  }

  /** The query that computes the same motions at the current time. */
  command(): Command | undefined {
    if (this.#asked === undefined || this.#fleet === undefined) return undefined;
    const time = this.#player === undefined || this.#player.isRunning || this.#player.time === 0 ? "0:10:1" : String(this.#player.time);
    return question(this.#asked.system, this.#form.value("tolerance"), time);
  }

  #update(): void {
    const asked = this.#asked;
    if (asked === undefined) return;
    const isRunning = this.#player?.isRunning === true;
    const key = JSON.stringify([asked, this.#form.value("motions"), this.#form.value("tolerance")]);
    if (key === this.#begun) return;
    this.#end();
    this.#form.clear();
    const count = Number(this.#form.value("motions"));
    if (!Number.isInteger(count) || count < 2 || count > MOST) return this.#refuse({ ...plainError(words.howMany), parameters: ["--motions"] });
    const [from, to] = asked.starts;
    const rows = from === undefined || to === undefined ? undefined : table(from, to, count);
    if (rows === undefined) return this.#fail("", words.twoStarts);
    const isAnew = this.#begun !== "";
    [this.#begun, this.#rows] = [key, rows];
    void this.#begin(asked.system, rows, isAnew ? 0 : Number(this.#address.get("time") ?? 0) || 0).then(() => {
      // A motion that ran before a change runs on after it.
      if (isRunning && this.#player?.isRunning === false) this.#toggle();
    });
  }

  async #begin(system: Command, rows: string, time: number): Promise<void> {
    const number = ++this.#number;
    this.#fail("");
    this.#status.textContent = words.begins;
    const begun = await Fleet.begin(this.#engine, system, this.#form.value("tolerance"), rows);
    if (number !== this.#number) return begun instanceof Fleet ? begun.close() : undefined;
    if (!(begun instanceof Fleet)) return this.#refuse(begun.error);
    this.#fleet = begun;
    this.#moving.hidden = false;
    const { facts } = begun;
    this.#stage.begin(facts.bodies);
    this.#plane.begin(axes(facts), facts.names.length);
    this.#stroboscope.begin(axes(facts), facts.names.length);
    this.#stroboscope.plot.element.hidden = !Number.isFinite(facts.period);
    this.#growth.begin();
    [this.#first, this.#trustEnds, this.#pace] = [0, undefined, ""];
    this.#player = new Player(begun, (frame) => this.#picture(frame), (frame) => this.#stroboscope.keep(frame.states), (reason) => this.#fail(text.engine.fault(reason)));
    this.#setSpeed();
    this.#changed();
    await this.#player.goTo(0);
    if (time > 0) await this.#player.goTo(time, (now) => (this.#status.textContent = words.goes(digits(now, 3), String(time))));
    this.#status.textContent = "";
    this.#label();
    this.#speak();
    this.#changed();
  }

  #picture(frame: Frame): void {
    this.#frame = frame;
    if (frame.time === 0) {
      this.#first = frame.spread;
      this.#stroboscope.keep(frame.states);
    }
    if (this.#trustEnds === undefined && frame.error > frame.spread / 100) this.#trustEnds = frame.time;
    this.#stage.show(frame.bodies);
    this.#plane.show(frame.states);
    this.#growth.add(frame.time, frame.spread, frame.error);
    if (performance.now() - this.#read > READABLE) this.#speak();
  }

  #speak(): void {
    const [frame, fleet, player] = [this.#frame, this.#fleet, this.#player];
    if (frame === undefined || fleet === undefined || player === undefined) return;
    this.#read = performance.now();
    const pace = player.isPlaying ? player.pace() : undefined;
    if (pace !== undefined) this.#pace = words.pace(pace.pictures, digits(pace.pace, 2));
    const now = words.now(fleet.facts.count, digits(frame.time, 4));
    const checked = Math.min(CHECKED, fleet.facts.count);
    const sentences = [
      now,
      words.apart(digits(frame.spread, 2), digits(this.#first, 2)),
      words.trusted(this.#form.value("tolerance"), checked, CLOSE, digits(frame.error, 2)),
      this.#trustEnds === undefined ? words.trustLasts : words.trustEnds(digits(this.#trustEnds, 3)),
      ...(frame.ended > 0 ? [words.ended(frame.ended, frame.cause)] : []),
      ...(player.isPlaying ? [this.#pace] : []),
    ];
    this.#words.textContent = sentences.join(" ");
    for (const [picture, what] of [[this.#stage, words.bodies], [this.#plane, words.plane], [this.#stroboscope, words.stroboscope], [this.#growth, words.growth]] as const) {
      picture.describe(words.picture(what, picture === this.#growth ? sentences.slice(0, 4).join(" ") : now));
    }
  }

  #toggle(): void {
    const player = this.#player;
    if (player === undefined) return;
    if (player.isRunning) void this.#stopped(player.pause());
    else {
      this.#pace = "";
      player.run();
      this.#address.put({ time: undefined });
    }
    this.#label();
  }

  #restart(): void {
    this.#end();
    this.#address.put({ time: undefined });
    this.#update();
  }

  #step(): Promise<void> {
    const player = this.#player;
    return player === undefined ? Promise.resolve() : this.#stopped(player.pause().then(() => player.step()));
  }

  async #stopped(work: Promise<void>): Promise<void> {
    await work;
    if (this.#player === undefined) return;
    this.#address.put({ time: String(this.#player.time) });
    this.#label();
    this.#speak();
    this.#changed();
  }

  #label(): void {
    const isRunning = this.#player?.isRunning === true;
    this.#run.textContent = isRunning ? words.pause : words.run;
    // The states of motions that run change before they are read.
    this.#table.offer(!isRunning);
  }

  #setSpeed(): void {
    if (this.#player !== undefined) this.#player.speed = Number(this.#form.value("fleet-speed")) || 1;
  }

  #end(): void {
    this.#number += 1;
    this.#player?.close();
    [this.#player, this.#fleet, this.#frame, this.#begun] = [undefined, undefined, undefined, this.#begun === "" ? "" : "ended"];
    this.#label();
  }

  #refuse(error: QueryError): void {
    this.#fail(this.#form.blame({ status: 2, output: new Uint8Array(), error, files: new Map() }));
  }

  /** Shows why there is no ensemble: an error, or a missing entry. */
  #fail(reason: string, missing = ""): void {
    this.#failure.textContent = reason;
    this.#failure.hidden = reason === "";
    this.#status.textContent = missing;
    this.#moving.hidden = this.#fleet === undefined;
  }

  async #savePicture(): Promise<void> {
    const all = [this.#stage.canvas, this.#plane.plot.canvas, this.#stroboscope.plot.canvas, this.#growth.plot.canvas];
    save("fleet.png", await painted(all.filter((canvas) => canvas.checkVisibility())), "image/png");
  }

  #saveStates(): void {
    if (this.#frame !== undefined) save("states.csv", this.#states(), "text/csv");
  }

  #states(): string {
    const [frame, fleet] = [this.#frame, this.#fleet];
    if (frame === undefined || fleet === undefined) return "";
    const { names } = fleet.facts;
    const row = (n: number) => [n + 1, frame.time, ...frame.states.subarray(n * names.length, (n + 1) * names.length)].join(",");
    return `${[["motion", "t", ...names].join(","), ...Array.from({ length: fleet.facts.count }, (_, n) => row(n))].join("\n")}\n`;
  }
}

function legend(): HTMLElement {
  const [spread = "", error = ""] = words.legend;
  return element("p", { class: "hint fleet-legend" }, element("span", { class: "solid" }, spread), " ", element("span", { class: "dashed" }, error));
}
