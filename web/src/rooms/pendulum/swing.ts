// The moving part of the room: the initial state from the fields, the course of the motion, and all displays of it.

import type { Address } from "../../address.ts";
import type { Engine } from "../../engine/engine.ts";
import type { Mathematics, Motion, Reading } from "../../engine/mathematics.ts";
import { read } from "../../parts/answers.ts";
import { type Command, given } from "../../parts/command.ts";
import { button, element } from "../../parts/element.ts";
import { angle as angleInWords, digits } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import { Clock } from "../../parts/clock.ts";
import { onColours } from "../../parts/colours.ts";
import { Controls } from "./controls.ts";
import { type Course, ExactCourse, type IntegratedCourse, type Place } from "./course.ts";
import type { Drawn, Shown } from "./drawing.ts";
import { Bars } from "./bars.ts";
import { Facts } from "./facts.ts";
import { APPROXIMATIONS, approximate, type Ghost, withPeriod } from "./ghosts.ts";
import { energies, Graphs, type Quantity } from "./graphs.ts";
import { command as forced, FORCE_OF, type Forces, integrated, isNone } from "./integration.ts";
import { Gate } from "./gate.ts";
import { Keep } from "./keep.ts";
import type { Range } from "../../parts/plot.ts";
import { Readouts } from "./readouts.ts";
import { Learn } from "./learn.ts";
import { Ruler } from "./ruler.ts";
import { Second } from "./second.ts";
import { Stage } from "./stage.ts";
import { StateButtons } from "./state_buttons.ts";
import { Stopwatch } from "./stopwatch.ts";
import { TrialsTable } from "./trials_table.ts";
import type { Laws } from "./trials_plots.ts";
import { Tone } from "./tone.ts";
import { Transport } from "./transport.ts";

const words = text.pendulum;

/** Length of the first and of the longest integration, in seconds. */
const [AHEAD, FARTHEST] = [60, 3840];
/** Length of the trace, in seconds. */
const TRACED = 1;
/** Bound on the time in an address, in seconds. */
const LATEST = 1e15;
/** Time between two changes of displayed numbers, in milliseconds. */
const READABLE = 100;

export class Swing {
  readonly #address: Address;
  readonly #engine: Engine;
  readonly #mathematics: Mathematics;
  readonly #clock = new Clock(() => this.#picture());
  readonly #controls: Controls;
  readonly #transport: Transport;
  readonly #stage: Stage;
  readonly #graphs: Graphs;
  readonly #facts = new Facts();
  readonly #readouts = new Readouts();
  readonly #bars = new Bars();
  readonly #learn = new Learn();
  readonly #gate = new Gate((swings, seconds) => this.#record(swings, seconds));
  readonly #stopwatch = new Stopwatch((swings, seconds) => this.#record(swings, seconds));
  readonly #trials: TrialsTable;
  readonly #state: StateButtons;
  readonly #ruler = new Ruler();
  readonly #second = new Second();
  readonly #tone = new Tone();
  readonly #keep: Keep;
  readonly #how = element("p", { class: "quiet how" });
  readonly #said = element("p", { class: "unseen", role: "status" });
  /** The way to the table, which says what it holds. */
  readonly #seen = element("p", { class: "seen", role: "status" });
  readonly #listen: HTMLButtonElement;
  readonly #closing: (() => void)[] = [];
  #motion: Motion | undefined;
  #course: Course | undefined;
  #length = 1;
  #gravity = 1;
  /** The settings of the motion that was started last. */
  #started = "";
  #ghosts: readonly Ghost[] = [];
  #window: Range | undefined;
  #wasRunning = false;
  #read = 0;
  #abort = new AbortController();

  constructor(place: HTMLElement, address: Address, engine: Engine, mathematics: Mathematics) {
    [this.#address, this.#engine, this.#mathematics] = [address, engine, mathematics];
    this.#controls = new Controls(address, () => this.#start(this.#physics() !== this.#started), () => void this.#offerFormulas());
    this.#graphs = new Graphs((angle, velocity) => this.#letGo(angle, velocity), ...this.#controls.axes);
    this.#stage = new Stage(words.stage, { held: (angle) => this.#held(angle), letGo: (angle, velocity) => this.#letGo(angle, velocity), taken: () => this.#taken(), turned: (by) => this.#turned(by) });
    this.#transport = new Transport(this.#clock, address.get("speed") ?? "1", () => this.#moved());
    this.#listen = button(words.listen, () => this.#sound(), { title: words.listenHint, "aria-pressed": "false" });
    this.#keep = new Keep(engine);
    this.#state = new StateButtons(address);
    this.#trials = new TrialsTable(address, engine, () => this.#laws());
    this.#lay(place);
    const time = Number(address.get("t") ?? "0");
    this.#clock.time = time > 0 && time < LATEST ? time : 0;
    this.#start(false);
    if (address.get("t") === undefined && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.#clock.run();
    this.#transport.show();
  }

  close(): void {
    this.#clock.stop();
    this.#abort.abort();
    document.documentElement.classList.remove("lecture");
    this.#graphs.close();
    this.#trials.close();
    this.#state.close();
    this.#stage.close();
    this.#tone.close();
    for (const close of this.#closing) close();
  }

  #lay(place: HTMLElement): void {
    const hint = element("p", { class: "try" }, words.lead);
    const cards = element("div", { class: "cards" }, this.#learn.element, this.#gate.element, this.#stopwatch.element, this.#seen);
    const stage = element("div", { class: "bench-stage" }, this.#stage.element, this.#readouts.element, this.#ruler.element, this.#bars.element, hint);
    const panel = element("div", { class: "bench-panel controls" }, ...this.#controls.panel, this.#state.element);
    const bench = element("div", { class: "bench" }, stage, cards, this.#transport.element, panel);
    const graphs = element("div", { class: "swing-graphs" }, ...this.#graphs.elements);
    const further = element("div", { class: "swing-controls controls" }, ...this.#controls.further);
    const below = element("div", { class: "swing-below" }, element("div", {}, this.#facts.element, element("p", { class: "buttons screen-only" }, this.#listen)), this.#keep.element);
    place.append(bench, element("div", { class: "swing" }, this.#how, this.#said, this.#trials.element, graphs, further, below));
    bench.addEventListener("keydown", (event) => {
      if (event.defaultPrevented || !stage.contains(event.target as Node)) return;
      if (this.#transport.key(event) || this.#undoKey(event)) event.preventDefault();
    });
    this.#closing.push(onColours(() => [this.#stage, this.#graphs, this.#ruler, this.#trials].forEach((it) => it.redraw())));
  }

  /** Undoes and redoes by the usual keys; returns `true` for such a key. */
  #undoKey(event: KeyboardEvent): boolean {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
    const isRedo = event.key === "y" || event.key === "Z";
    if (!isRedo && event.key !== "z") return false;
    if (isRedo) this.#address.redo();
    else this.#address.undo();
    return true;
  }

  /** Starts the motion that the fields describe, from its beginning unless the time is kept. */
  #start(isFromStart = true): void {
    this.#abort.abort();
    this.#abort = new AbortController();
    this.#controls.form.clear();
    this.#showInstruments();
    const motion = this.#launched();
    if (motion === undefined) return;
    this.#started = this.#physics();
    if (isFromStart) {
      this.#clock.time = 0;
      this.#address.put({ t: undefined });
    }
    this.#motion = motion;
    this.#window = undefined;
    const forces = this.#forces(motion);
    this.#course = forces === undefined ? new ExactCourse(this.#mathematics) : undefined;
    this.#how.textContent = forces === undefined ? words.byFormula : words.byIntegration;
    if (forces !== undefined) void this.#integrate(forces, AHEAD);
    this.#gate.begin(this.#clock.time);
    void this.#startSecond(forces);
    this.#ghosts = forces === undefined ? APPROXIMATIONS.filter((key) => this.#value(key) === "yes").flatMap((key) => approximate(this.#mathematics, key) ?? []) : [];
    const wanted = APPROXIMATIONS.some((key) => this.#value(key) === "yes") || this.#value("formula") !== "";
    if (forces === undefined && wanted && this.#mathematics.approximation(0, 0, 0, 1) === undefined) this.#how.textContent += ` ${words.ghostsNeedRest}`;
    void this.#addFormula(motion);
    this.#describe(motion, forces);
    this.#trials.update();
    this.#picture();
  }

  /** Puts a measured time into the table, with the amplitude in degrees and the length, unless it is hidden. */
  #record(swings: number, seconds: string): void {
    const degrees = (180 / Math.PI) * (this.#motion?.amplitude ?? 0);
    const length = this.#controls.isHidden("length") ? "" : String(Number(this.#length.toPrecision(6)));
    const count = this.#trials.add(String(Number(degrees.toPrecision(6))), length, swings, seconds);
    this.#seen.replaceChildren(button(words.trials.see(words.trials.caption(count)), () => this.#trials.element.scrollIntoView()));
  }

  #laws(): Laws {
    const amplitude = (180 / Math.PI) * (this.#motion?.amplitude || 0);
    return { gravity: this.#gravity, length: this.#length, amplitude: Math.min(179, amplitude), isHidden: this.#controls.isHidden("period"), formula: this.#value("formula") };
  }

  #launched(): Motion | undefined {
    const { form } = this.#controls;
    const quantity = (key: string, reading: Reading) => {
      if ("error" in reading) this.#controls.refuse(key, reading.error);
      return valueOf(reading);
    };
    const angle = this.#mathematics.angle(form.value("angle"));
    if ("error" in angle) this.#controls.refuse("angle", angle.error);
    else this.#controls.slide((180 / Math.PI) * angle.inTurn, angleInWords(angle.inTurn, form.value("unit")));
    const velocity = quantity("velocity", this.#mathematics.angularVelocity(form.value("velocity") || "0"));
    const { secret } = this.#controls;
    const length = secret.length ?? quantity("length", this.#mathematics.length(form.value("length")));
    const gravity = secret.gravity ?? quantity("gravity", this.#mathematics.acceleration(form.value("gravity")));
    this.#controls.show();
    if (secret.gravity === undefined) this.#controls.name(gravity, (entry) => valueOf(this.#mathematics.acceleration(entry)));
    if ("error" in angle || velocity === undefined || length === undefined || gravity === undefined) return undefined;
    const motion = this.#mathematics.launch(form.value("angle"), velocity, length, gravity);
    if (!("error" in motion)) {
      [this.#length, this.#gravity] = [length, gravity];
      if (secret.length === undefined) this.#controls.slideLength(length);
      this.#readouts.show(motion, length, gravity, this.#forces(motion) === undefined, form.value("unit"), (key) => this.#controls.isHidden(key));
      return motion;
    }
    this.#controls.refuse(motion.quantity, motion.error);
    return undefined;
  }

  #value(key: string): string {
    return this.#controls.form.value(key);
  }

  /** Damping and driving, if there are any. */
  #forces({ angularFrequency }: Motion): Forces | undefined {
    const [damping = "", drag = "", dry = "", drive = "", driveFrequency = ""] = ["damping", "drag", "dry", "drive", "driveFrequency"].map((key) => this.#value(key));
    if ([damping, drag, dry, drive].every(isNone)) return undefined;
    const velocity = this.#mathematics.angularVelocity(this.#value("velocity") || "0");
    return { angle: this.#value("angle"), velocity: "value" in velocity ? velocity.value : 0, angularFrequency, damping, drag, dry, drive, driveFrequency };
  }

  async #integrate(forces: Forces, until: number): Promise<void> {
    const { signal } = this.#abort;
    if (this.#course === undefined) this.#said.textContent = words.integrating;
    const course = await integrated(this.#engine, forces, until, signal);
    if (signal.aborted) return;
    this.#said.textContent = "";
    if ("error" in course) {
      const [, present = "damping"] = Object.entries(FORCE_OF).find(([, key]) => !isNone(this.#value(key))) ?? [];
      return this.#controls.refuse(FORCE_OF[course.item] ?? present, course.error);
    }
    this.#course = course;
    this.#window = undefined;
    this.#picture();
    if (this.#value("second") === "yes") {
      await this.#second.integrate(this.#engine, forces, this.#value("angle2"), until, signal);
      if (signal.aborted) return;
      this.#window = undefined;
      this.#picture();
    }
    if (until < FARTHEST) this.#ahead = { forces, course, until };
  }

  #ahead: { forces: Forces; course: IntegratedCourse; until: number } | undefined;

  /** Adds the exact motion rescaled to the period of the chosen formula. */
  async #addFormula(motion: Motion): Promise<void> {
    const key = this.#value("formula");
    if (key === "" || motion.regime !== "libration" || this.#course === undefined) return;
    const { signal } = this.#abort;
    const amplitude = motion.complement < 0.1 ? `pi-${motion.complement}` : String(motion.amplitude);
    const command: Command = { question: "period", arguments: [amplitude], options: given({ length: this.#value("length"), gravity: this.#value("gravity"), formulas: key }) };
    const { value } = await read<{ results: { formulas: { key: string; period_s: number | null }[] }[] }>(this.#engine, command, signal);
    const period = value?.results[0]?.formulas.find((it) => it.key === key)?.period_s;
    if (signal.aborted || period == null) return;
    this.#ghosts = [...this.#ghosts, withPeriod(this.#mathematics, key, motion, period)];
    this.#window = undefined;
    this.#picture();
  }

  async #offerFormulas(): Promise<void> {
    const { value } = await read<{ formulas: { key: string; name: string }[] }>(this.#engine, { question: "formulas" }, new AbortController().signal);
    if (value !== undefined) this.#controls.offer(value.formulas.map(({ key, name }) => [key, name]));
  }

  #describe(motion: Motion, forces: Forces | undefined): void {
    const unit = this.#value("unit");
    const period = Number.isFinite(motion.period) && motion.period > 0 ? `${digits(motion.period, 6)} s` : words.graphs.none;
    const regime = forces === undefined ? words.regimes[motion.regime] : words.forced;
    const start = this.#mathematics.angle(this.#value("angle"));
    const degrees = "error" in start ? 0 : (180 / Math.PI) * start.inTurn;
    this.#facts.show(motion, forces === undefined, unit);
    this.#stage.describe(Number(degrees.toFixed(4)), `${this.#value("angle").replaceAll("deg", "°")}: ${regime}`);
    const isHidden = this.#controls.isHidden("period");
    if (forces === undefined) this.#said.textContent = isHidden ? `${regime}.` : words.announce(regime, period);
    const { form } = this.#controls;
    const chosen = { velocity: form.chosen("velocity"), length: form.chosen("length"), gravity: form.chosen("gravity") };
    const exact: Command = { question: "motion", arguments: [this.#value("angle")], options: given(chosen) };
    const compared = APPROXIMATIONS.filter((key) => this.#value(key) === "yes" && this.#ghosts.some((ghost) => ghost.key === key));
    this.#keep.show(forces === undefined ? exact : forced(forces, 20), forces === undefined ? compared : [], forces === undefined ? shownTimes(motion) : undefined);
    this.#listen.disabled = forces !== undefined || motion.regime !== "libration";
    if (this.#tone.sounds) this.#sound(true);
  }

  /** Shows the present moment. */
  #picture(): void {
    const [motion, course] = [this.#motion, this.#course];
    if (motion === undefined) return;
    if (course === undefined) return this.#showRelease();
    this.#lookAhead();
    let place = course.at(this.#clock.time);
    if (place === undefined && "end" in course) {
      // The integration is not as far yet: the pendulum waits.
      this.#clock.time = (course as IntegratedCourse).end;
      place = course.at(this.#clock.time);
    }
    if (place === undefined) return;
    const { time } = this.#clock;
    this.#showWindow(motion, course);
    const angles = this.#ghosts.map((ghost) => ghost.angles(time, 0, 1)[0] ?? NaN);
    const frame = this.#stage.show(this.#scene(place, this.#traced(course, time), this.#ghosts.map(({ colour }, n) => ({ colour, angle: angles[n] ?? NaN }))));
    this.#ruler.fit(frame, this.#length);
    this.#graphs.mark(time, place, angles);
    this.#readouts.now(time);
    this.#stopwatch.follow(time);
    this.#gate.follow(course, time, fastestPeriod(motion, course instanceof ExactCourse));
    this.#energy(motion, place);
    if (performance.now() - this.#read > READABLE || !this.#clock.isRunning) {
      this.#read = performance.now();
      this.#facts.now(time, place, this.#second.course?.at(time));
    }
  }

  /** Shows the pendulum where it is released, as long as its motion is not known. */
  #showRelease(): void {
    const angle = this.#mathematics.angle(this.#value("angle"));
    if (!("error" in angle)) this.#stage.show(this.#scene({ angle: angle.inTurn, velocity: 0 }, [], []));
  }

  /** What the stage shows of a state. */
  #scene({ angle, velocity }: Pick<Place, "angle" | "velocity">, trace: ArrayLike<number>, ghosts: Shown["ghosts"]): Shown {
    const fastest = 2 * (this.#motion?.angularFrequency ?? 1);
    const first: Drawn = { angle, velocity, length: this.#length, colour: "curve-1", bob: this.#bob("mass"), fastest, trace };
    const second = this.#second.drawn(this.#clock.time, this.#bob("mass2"), (course) => this.#traced(course, this.#clock.time));
    const isOn = (key: string) => this.#value(key) === "yes";
    const pendulums = second === undefined ? [first] : [first, second];
    return { pendulums, ghosts, arrows: isOn("arrows"), gate: isOn("gate") ? this.#gate.isBroken(angle) : undefined, protractor: isOn("protractor"), unit: this.#value("unit") };
  }

  /** The radius of a bob of the usual density, relative to that of 1 kg. */
  #bob(key: string): number {
    const mass = massOf(this.#value(key));
    return mass === undefined || !(mass > 0) ? 1 : Math.min(2, Math.max(0.5, Math.cbrt(mass)));
  }

  /** 2mgl in joules, if the mass is known and gives nothing away. */
  #joules(): number | undefined {
    const mass = massOf(this.#value("mass"));
    return mass === undefined || this.#controls.isHidden("period") ? undefined : 2 * mass * this.#gravity * this.#length;
  }

  #showInstruments(): void {
    const instruments = { gate: this.#gate, stopwatch: this.#stopwatch, ruler: this.#ruler };
    for (const [key, { element: its }] of Object.entries(instruments)) its.hidden = this.#value(key) !== "yes";
    const view = this.#value("view");
    this.#learn.element.hidden = view !== "learn";
    document.documentElement.classList.toggle("lecture", view === "lecture");
    const isHidden = this.#controls.isHidden("period");
    this.#facts.element.hidden = this.#keep.element.hidden = isHidden;
    for (const key of ["mass", "mass2"]) if (this.#value(key) !== "" && massOf(this.#value(key)) === undefined) this.#controls.refuse(key, words.fields.wrongMass);
  }

  async #startSecond(forces: Forces | undefined): Promise<void> {
    const { signal } = this.#abort;
    if (this.#value("second") !== "yes") return this.#second.clear();
    const launched = await this.#second.launch({ angle: this.#value("angle2"), length: this.#value("length2"), gravity: this.#value("gravity2") });
    if (signal.aborted) return;
    if ("error" in launched) return this.#controls.refuse(`${launched.quantity}2`, launched.error);
    if (forces === undefined) this.#second.follow();
    this.#window = undefined;
    this.#picture();
  }

  /** What decides the motion: after other changes the time goes on. */
  #physics(): string {
    return ["angle", "velocity", "length", "gravity", "damping", "drag", "dry", "drive", "driveFrequency", "secret", "second", "angle2", "length2", "gravity2"].map((key) => this.#value(key)).join("\n");
  }

  /** The angles of the last moments, if a trace is shown. */
  #traced(course: Course, time: number): ArrayLike<number> {
    if (this.#value("trace") !== "yes") return [];
    const from = Math.max(0, time - TRACED);
    return course.samples(from, (time - from) / 39, 40).angles;
  }

  #energy(motion: Motion, { angle, velocity }: Place): void {
    const isShown = this.#value("bars") === "yes";
    this.#bars.element.hidden = !isShown;
    if (!isShown) return;
    const [kinetic, potential] = energies(angle, velocity, 2 * motion.angularFrequency);
    // The work of a drive would have to be known too.
    const hasFriction = isNone(this.#value("drive")) && this.#forces(motion) !== undefined;
    const heat = hasFriction ? Math.max(0, motion.energyRatio - kinetic - potential) : undefined;
    this.#bars.show(kinetic, potential, heat, Math.max(1, motion.energyRatio), this.#joules());
  }

  #lookAhead(): void {
    const ahead = this.#ahead;
    if (ahead === undefined || this.#course !== ahead.course || this.#clock.time < ahead.course.end / 2) return;
    this.#ahead = undefined;
    void this.#integrate(ahead.forces, 2 * ahead.until);
  }

  /** Lets the graphs show the present time: from four fifths of the interval on, the interval moves with it. */
  #showWindow(motion: Motion, course: Course): void {
    const length = shownTimes(motion);
    const first = Math.max(0, this.#clock.time - 0.8 * length);
    const window: Range = [first, first + length];
    const shown = this.#window;
    if (shown?.[0] === first) return;
    this.#window = window;
    if (shown !== undefined) return this.#graphs.slide(window);
    const isExact = course instanceof ExactCourse;
    const isHidden = this.#controls.isHidden("period");
    const harmonics = isExact && ["libration", "rotation"].includes(motion.regime) ? this.#mathematics.harmonics(1e-12, 60) : undefined;
    this.#graphs.show({ course, motion, isExact, harmonics, ghosts: this.#ghosts, second: this.#second.course, window: this.#window, unit: this.#value("unit"), free: [this.#value("across") as Quantity, this.#value("up") as Quantity], isHidden });
  }

  /** Writes the time to the address after it was changed by hand, or has begun or ceased to run. */
  #moved(): void {
    const { speed } = this.#transport;
    this.#address.put({ t: this.#clock.isRunning ? undefined : String(Number(this.#clock.time.toFixed(6))), speed: unless(speed, "1") });
    this.#picture();
  }

  #held(angle: number): void {
    if (this.#clock.isRunning) {
      this.#wasRunning = true;
      this.#clock.stop();
    }
    this.#stage.show(this.#scene({ angle, velocity: 0 }, [], []));
  }

  /** Releases the bob; within half a degree of the top it is released exactly there. */
  #letGo(angle: number, velocity: number): void {
    const degrees = (180 / Math.PI) * angle;
    const top = Math.abs(Math.abs(degrees) - 180) < 0.5 && velocity === 0;
    this.#controls.form.put("angle", top ? "180deg" : `${Number(degrees.toFixed(1))}deg`);
    this.#controls.form.put("velocity", velocity === 0 ? "0" : `${velocity.toFixed(2)}rad/s`);
    this.#start();
    this.#resume();
  }

  /** Continues the motion unchanged after the system took the pointer away. */
  #taken(): void {
    this.#picture();
    this.#resume();
  }

  #turned(by: number): void {
    const reading = this.#mathematics.angle(this.#value("angle"));
    const degrees = "error" in reading ? 0 : (180 / Math.PI) * reading.inTurn;
    const turned = Math.max(-180, Math.min(180, degrees + by));
    this.#controls.form.put("angle", `${Number(turned.toFixed(1))}deg`);
    this.#start();
  }

  #resume(): void {
    if (this.#wasRunning) this.#clock.run();
    this.#wasRunning = false;
    this.#transport.show();
  }

  #sound(isOn = !this.#tone.sounds): void {
    const motion = this.#motion;
    if (isOn && motion?.regime === "libration") this.#tone.play(this.#mathematics.harmonics(1e-6, 64), motion.smallAnglePeriod / motion.period);
    else this.#tone.stop();
    this.#listen.textContent = this.#tone.sounds ? words.silent : words.listen;
    this.#listen.setAttribute("aria-pressed", String(this.#tone.sounds));
  }
}

/** A mass in kilograms, entered in kg or g. */
function massOf(entry: string): number | undefined {
  const [, number, unit] = /^\s*([\d.]+)\s*(kg|g)\s*$/.exec(entry.replace(",", ".")) ?? [];
  const value = Number(number) / (unit === "g" ? 1000 : 1);
  return number !== undefined && value > 0 ? value : undefined;
}

function valueOf(reading: Reading): number | undefined {
  return "value" in reading ? reading.value : undefined;
}

/** `undefined` for the usual value, which is omitted. */
function unless(value: string, usual: string): string | undefined {
  return value === usual ? undefined : value;
}

/** The shortest time between passages that the photogate has to follow; forces may drive a pendulum over the top. */
function fastestPeriod({ regime, period, smallAnglePeriod }: Motion, isExact: boolean): number {
  if (!isExact) return smallAnglePeriod / 4;
  return regime === "rotation" ? Math.min(period, smallAnglePeriod) : smallAnglePeriod;
}

/** Length of the graphs' time axis, in seconds: three periods, or a time that can be watched if the period is infinite or very long. */
function shownTimes({ period, smallAnglePeriod }: Motion): number {
  const usual = 5 * smallAnglePeriod;
  return Number.isFinite(period) && period > 0 ? Math.min(3 * period, 12 * usual) : usual;
}
