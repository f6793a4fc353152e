// The linked graphs: angle, velocity, phase plane, energy, any quantity against any other, harmonics, epicycles.

import { element } from "../../parts/element.ts";
import type { Harmonics, Motion } from "../../engine/mathematics.ts";
import { angle as angleInWords, digits, short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Course, Place, Samples } from "./course.ts";
import type { Ghost } from "./ghosts.ts";
import { type Axes, multiples, type Pen, type Plot, type Range } from "../../parts/plot.ts";
import { lookedAt } from "./look.ts";

const { graphs: words, look } = text.pendulum;
/** Fewest and most samples of a curve, and those of one small-angle period between. */
const [FEWEST, MOST, PER_PERIOD] = [300, 900, 40];
/** Energies over 2mgl of the orbits that are drawn in the background of the phase plane. */
const FAMILY = [0.07, 0.25, 0.5, 0.75, 0.93, 1.2, 1.5];

/** Quantities that can be drawn against each other. */
export const QUANTITIES = ["time", "angle", "velocity", "acceleration", "kinetic", "potential", "total"] as const;
export type Quantity = (typeof QUANTITIES)[number];

/** All quantities of a state; the acceleration is that by gravity. */
function quantities(time: number, angle: number, velocity: number, frequency: number): Record<Quantity, number> {
  const [kinetic, potential] = energies(angle, velocity, 2 * frequency);
  return { time, angle, velocity, acceleration: -(frequency ** 2) * Math.sin(angle), kinetic, potential, total: kinetic + potential };
}

/** The data to draw. */
export interface Scene {
  readonly course: Course;
  readonly motion: Motion;
  /** `false` for damped and driven motions, for which `motion` describes only the initial state. */
  readonly isExact: boolean;
  /** Harmonics of the motion; `undefined` for integrated motions. */
  readonly harmonics: Harmonics | undefined;
  readonly ghosts: readonly Ghost[];
  /** The motion of a second pendulum, if it is known. */
  readonly second: Course | undefined;
  /** The times that are shown. */
  readonly window: Range;
  /** `deg` or `rad`. */
  readonly unit: string;
  /** The quantities of the free graph, across and up. */
  readonly free: readonly [Quantity, Quantity];
  /** `true` if the period must not be said. */
  readonly isHidden: boolean;
}

export class Graphs {
  readonly elements: readonly HTMLElement[];
  readonly #angle = lookedAt(words.angle.title, look.angle);
  readonly #velocity = lookedAt(words.velocity.title, look.velocity);
  readonly #phase = lookedAt(words.phase.title, look.phase);
  readonly #energy = lookedAt(words.energy.title, look.energy);
  readonly #spectrum = lookedAt(words.spectrum.title, look.spectrum);
  readonly #epicycles = lookedAt(words.epicycles.title, look.epicycles);
  readonly #free: Plot;
  #scene: Scene | undefined;
  /** The ranges of values that have been shown of this motion: they only grow. */
  #ranges = new Map<Plot | string, Range>();

  /** `started` is called with the angle in rad and the velocity in rad/s that are clicked in the phase plane; `axes` are the fields of the free graph. */
  constructor(started: (angle: number, velocity: number) => void, ...axes: Node[]) {
    this.#free = lookedAt(words.free.title, look.free, element("div", { class: "axes" }, ...axes));
    this.elements = this.#all.map((plot) => plot.element);
    this.#phase.canvas.classList.add("clicked");
    this.#phase.onPoint((angle, velocity) => Math.abs(angle) <= Math.PI && started(angle, velocity));
  }

  get #all(): Plot[] {
    return [this.#phase, this.#angle, this.#velocity, this.#energy, this.#free, this.#spectrum, this.#epicycles];
  }

  /** Moves the interval of time that is shown. */
  slide(window: Range): void {
    if (this.#scene === undefined) return;
    this.#scene = { ...this.#scene, window };
    this.#showInterval(this.#scene);
  }

  #showInterval(scene: Scene): void {
    const length = scene.window[1] - scene.window[0];
    const points = scene.isExact ? Math.round(Math.min(MOST, Math.max(FEWEST, (PER_PERIOD * length) / scene.motion.smallAnglePeriod))) : MOST;
    const step = length / (points - 1);
    const samples = scene.course.samples(scene.window[0], step, points);
    const times = Float64Array.from(samples.angles, (_, n) => scene.window[0] + n * step);
    this.#showAngle(scene, times, samples, step);
    this.#showVelocity(scene, times, samples);
    this.#showEnergy(scene, times, samples);
    this.#showFree(scene, times, samples);
    if (!scene.isExact || this.#ranges.get(this.#phase) === undefined) this.#showPhase(scene, samples);
  }

  /** The range of this interval together with those before it. */
  #grown(plot: Plot | string, [low, high]: Range): Range {
    const [before, after] = this.#ranges.get(plot) ?? [low, high];
    const range: Range = [Math.min(low, before), Math.max(high, after)];
    this.#ranges.set(plot, range);
    return range;
  }

  show(scene: Scene): void {
    this.#scene = scene;
    this.#ranges = new Map();
    this.#showInterval(scene);
    this.#spectrum.element.hidden = this.#epicycles.element.hidden = scene.harmonics === undefined;
    if (scene.harmonics !== undefined) {
      this.#showSpectrum(scene, scene.harmonics);
      this.#showEpicycles(scene, scene.harmonics);
    }
  }

  /** Marks the current state, and those of the ghosts. */
  mark(time: number, place: Place, ghosts: readonly number[]): void {
    const scene = this.#scene;
    if (scene === undefined) return;
    const frequency = 2 * scene.motion.angularFrequency;
    const [kinetic, potential] = energies(place.angle, place.velocity, frequency);
    this.#angle.move((pen) => {
      scene.ghosts.forEach((ghost, n) => pen.dot(time, ghosts[n] ?? NaN, ghost.colour, 3.5));
      pen.dot(time, scene.second?.at(time)?.angle ?? NaN, "curve-4", 4);
      pen.dot(time, place.angle, "curve-1");
    });
    this.#velocity.move((pen) => pen.dot(time, place.velocity, "curve-1"));
    this.#phase.move((pen) => pen.dot(wrapped(place.angle), place.velocity, "curve-1"));
    this.#energy.move((pen) => {
      pen.dot(time, kinetic, "curve-2", 4);
      pen.dot(time, potential, "curve-3", 4);
      pen.dot(time, kinetic + potential, "curve-1", 4);
    });
    const now = quantities(time, place.angle, place.velocity, scene.motion.angularFrequency);
    this.#free.move((pen) => pen.dot(now[scene.free[0]], now[scene.free[1]], "curve-1"));
    const { harmonics } = scene;
    if (harmonics !== undefined) this.#epicycles.move((pen) => drawEpicycles(pen, harmonics, time));
  }

  redraw(): void {
    for (const plot of this.#all) plot.redraw();
  }

  close(): void {
    for (const plot of this.#all) plot.close();
  }

  #showAngle({ ghosts, second, motion, isExact, unit, window, isHidden }: Scene, times: Float64Array, { angles }: Samples, step: number): void {
    const curves = ghosts.map((ghost) => ({ ghost, angles: ghost.angles(window[0], step, angles.length) }));
    const other = second === undefined ? [] : [second.samples(window[0], step, angles.length).angles];
    const range = this.#grown(this.#angle, padded(extent([angles, ...other, ...curves.map((curve) => curve.angles)], Math.PI * 4)));
    const axes = { x: window, y: range, xLabel: words.time, yLabel: words.angle.axis(unit), ...angleTicks("y", range, unit) };
    const said = angleExtent(isExact, motion, angles).map((it) => angleInWords(it, unit, 4)) as [string, string];
    const period = isExact && !isHidden ? seconds(motion.period) : words.none;
    this.#angle.show(axes, words.angle.words(period, ...said) + (second === undefined ? "" : words.angle.second), (pen) => {
      for (const curve of curves) pen.line(times, curve.angles, curve.ghost.colour, 1.25, [5, 3]);
      for (const its of other) pen.line(times, its, "curve-4", 2);
      pen.line(times, angles, "curve-1", 2);
    });
  }

  #showVelocity({ window, motion, isExact }: Scene, times: Float64Array, { velocities }: Samples): void {
    const range = this.#grown(this.#velocity, padded(extent([velocities])));
    const said = velocityExtent(isExact, motion, velocities).map((it) => short(it, 4)) as [string, string];
    const axes = { x: window, y: range, xLabel: words.time, yLabel: words.velocity.axis };
    this.#velocity.show(axes, words.velocity.words(...said), (pen) => pen.line(times, velocities, "curve-1", 2));
  }

  #showPhase({ motion, isExact, unit, harmonics }: Scene, samples: Samples): void {
    const frequency = 2 * motion.angularFrequency;
    const fastest = this.#grown(this.#phase, [0, Math.max(frequency, ...samples.velocities.map(Math.abs).filter(Number.isFinite))])[1];
    const x: Range = [-Math.PI, Math.PI];
    const axes: Axes = { x, y: [-1.12 * fastest, 1.12 * fastest], xLabel: words.phase.x(unit), yLabel: words.velocity.axis, ...angleTicks("x", x, unit) };
    this.#phase.show(axes, words.phase.words(isExact ? text.pendulum.regimes[motion.regime] : text.pendulum.forced), (pen) => {
      const angles = Array.from({ length: 201 }, (_, n) => ((n - 100) * Math.PI) / 100);
      for (const energy of FAMILY) for (const side of [1, -1]) pen.line(angles, angles.map((it) => side * frequency * Math.sqrt(energy - Math.sin(it / 2) ** 2)), "line", 1);
      for (const side of [1, -1]) pen.line(angles, angles.map((it) => side * frequency * Math.cos(it / 2)), "quiet", 1.25, [5, 3]);
      const [xs, ys] = harmonics === undefined ? segments(samples) : orbit(motion, samples);
      pen.line(xs, ys, "curve-1", 2);
    });
  }

  #showEnergy({ motion, isExact, window }: Scene, times: Float64Array, { angles, velocities }: Samples): void {
    const frequency = 2 * motion.angularFrequency;
    const both = Array.from(angles, (angle, n) => energies(angle, velocities[n] ?? NaN, frequency));
    const all = both.map(([kinetic, potential]) => kinetic + potential);
    const top = this.#grown(this.#energy, [0, 1.22 * Math.max(...all.filter(Number.isFinite), 1e-300)])[1];
    const axes = { x: window, y: [0, top] as const, xLabel: words.time, yLabel: words.energy.axis };
    this.#energy.show(axes, words.energy.words(digits(motion.energyRatio, 6), isExact), (pen) => {
      pen.line(window, [1, 1], "quiet", 1.25, [5, 3]);
      pen.line(times, both.map(([kinetic]) => kinetic), "curve-2");
      pen.line(times, both.map(([, potential]) => potential), "curve-3");
      pen.line(times, all, "curve-1", 2);
      pen.legend([["curve-2", words.energy.kinetic], ["curve-3", words.energy.potential], ["curve-1", words.energy.total]]);
    });
  }

  #showFree({ motion, unit, window, free: [across, up] }: Scene, times: Float64Array, { angles, velocities }: Samples): void {
    const all = Array.from(times, (time, n) => quantities(time, angles[n] ?? NaN, velocities[n] ?? NaN, motion.angularFrequency));
    const [xs, ys] = [Float64Array.from(all, (it) => it[across]), Float64Array.from(all, (it) => it[up])];
    const [x, y] = [across === "time" ? window : this.#grown(across, padded(extent([xs]))), up === "time" ? window : this.#grown(up, padded(extent([ys])))];
    const ticksOf = (axis: "x" | "y", quantity: Quantity, range: Range) => (quantity === "angle" ? angleTicks(axis, range, unit) : {});
    const axes: Axes = { x, y, xLabel: words.free.quantities[across], yLabel: words.free.quantities[up], ...ticksOf("x", across, x), ...ticksOf("y", up, y) };
    this.#free.show(axes, words.free.words(words.free.quantities[up], words.free.quantities[across]), (pen) => pen.line(xs, ys, "curve-1", 2));
  }

  #showSpectrum(_: Scene, { terms }: Harmonics): void {
    const sizes = terms.map(({ angle }) => Math.log10(Math.abs(angle)));
    const [low, high] = [Math.floor(Math.min(...sizes, -2)), Math.ceil(Math.max(...sizes, 0))];
    const every = Math.max(1, Math.ceil((high - low) / 6));
    const powers = Array.from({ length: high - low + 1 }, (_, n) => low + n).filter((power) => (power - high) % every === 0);
    const axes: Axes = { x: [0, Math.max(8, terms.at(-1)?.n ?? 0) + 1], y: [low, high + 0.15 * (high - low)], xLabel: words.spectrum.x, yLabel: words.spectrum.axis, yTicks: powers.map((power) => [power, tenTo(power)]) };
    const said = terms.slice(0, 4).map(({ n, angle }) => `${n}: ${digits(angle, 4)} rad`).join(", ");
    this.#spectrum.show(axes, words.spectrum.words(said), (pen) => {
      for (const { n, angle } of terms) pen.line([n, n], [low, Math.log10(Math.abs(angle))], angle > 0 ? "curve-1" : "curve-2", 4);
      if (terms.some(({ angle }) => angle < 0)) pen.legend([["curve-1", words.spectrum.positive], ["curve-2", words.spectrum.negative]]);
    });
  }

  #showEpicycles({ unit }: Scene, { terms }: Harmonics): void {
    const size = Math.max(1e-300, terms.reduce((sum, { angle }) => sum + Math.abs(angle), 0));
    const x: Range = [-1.05 * size, 1.05 * size];
    const axes: Axes = { x, y: x, xLabel: words.epicycles.x(unit), yLabel: "", square: true, yTicks: [], ...angleTicks("x", [-size, size], unit, 2) };
    this.#epicycles.show(axes, words.epicycles.words(String(terms.length)), (pen) => pen.line(x, [0, 0], "line"));
  }
}

/** Each harmonic turns at its own rate; the end of the last one marks the angle. */
function drawEpicycles(pen: Pen, { fundamental, meanVelocity, epoch, terms }: Harmonics, time: number): void {
  // For rotations the angle is a uniform rotation plus a sum of sines.
  const shift = meanVelocity === 0 ? 0 : -Math.PI / 2;
  let [x, y] = [0, 0];
  for (const { n, angle } of terms.slice(0, 24)) {
    const phase = n * fundamental * (time - epoch) + shift;
    const [toX, toY] = [x + angle * Math.cos(phase), y + angle * Math.sin(phase)];
    pen.circle(x, y, Math.abs(angle), "line");
    pen.line([x, toX], [y, toY], "ink", 1.5);
    [x, y] = [toX, toY];
  }
  pen.line([x, x], [y, 0], "curve-1", 1, [3, 3]);
  pen.dot(x, 0, "curve-1");
}

/** Kinetic and potential energy over 2mgl. */
export function energies(angle: number, velocity: number, twiceFrequency: number): [number, number] {
  return [(velocity / twiceFrequency) ** 2, Math.sin(angle / 2) ** 2];
}

/** The exact orbit in the phase plane. */
function orbit({ regime, energyRatio, angularFrequency }: Motion, { velocities }: Samples): [number[], number[]] {
  const k = Math.sqrt(energyRatio);
  if (regime === "libration") {
    const phases = Array.from({ length: 401 }, (_, n) => (n * Math.PI) / 200);
    return [phases.map((phase) => 2 * Math.asin(k * Math.sin(phase))), phases.map((phase) => 2 * angularFrequency * k * Math.cos(phase))];
  }
  if (regime === "rest" || regime === "upright") return [[], []];
  const side = Math.sign(velocities[0] ?? 1);
  const angles = Array.from({ length: 401 }, (_, n) => ((n - 200) * Math.PI) / 200);
  return [angles, angles.map((angle) => side * 2 * angularFrequency * Math.sqrt(Math.max(0, energyRatio - Math.sin(angle / 2) ** 2)))];
}

/** A curve over whole turns, broken where it passes the top. */
function segments({ angles, velocities }: Samples): [number[], number[]] {
  const [xs, ys]: [number[], number[]] = [[], []];
  angles.forEach((angle, n) => {
    const x = wrapped(angle);
    if (Math.abs(x - (xs.at(-1) ?? x)) > Math.PI) {
      xs.push(NaN);
      ys.push(NaN);
    }
    xs.push(x);
    ys.push(velocities[n] ?? NaN);
  });
  return [xs, ys];
}

function wrapped(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** The range of the curves, with at most `most` for ghosts that diverge. */
function extent(curves: readonly Float64Array[], most = Infinity): Range {
  let [low, high] = [Infinity, -Infinity];
  for (const curve of curves) {
    for (const value of curve) {
      if (Math.abs(value) <= most || curve === curves[0]) [low, high] = [Math.min(low, value), Math.max(high, value)];
    }
  }
  return Number.isFinite(low) && Number.isFinite(high) ? [low, high] : [-1, 1];
}

/** The smallest and the largest angle: for swings from the amplitude, for others over the times shown. */
function angleExtent(isExact: boolean, { regime, amplitude }: Motion, angles: Float64Array): Range {
  return isExact && regime === "libration" ? [-amplitude, amplitude] : extent([angles]);
}

/** The smallest and the largest velocity: from the energy, for damped and driven motions over the times shown. */
function velocityExtent(isExact: boolean, { regime, energyRatio, energyExcess, angularFrequency }: Motion, velocities: Float64Array): Range {
  if (!isExact || !["libration", "rotation"].includes(regime)) return extent([velocities]);
  const [most, least] = [2 * angularFrequency * Math.sqrt(energyRatio), 2 * angularFrequency * Math.sqrt(Math.max(0, energyExcess))];
  if (regime === "libration") return [-most, most];
  return (velocities[0] ?? 0) < 0 ? [-most, -least] : [least, most];
}

function padded([low, high]: Range): Range {
  const room = low === high ? Math.max(Math.abs(low), 1e-3) : 0.04 * (high - low);
  return [low - room, high + room];
}

/** Ticks at fractions of a half turn. */
function angleTicks(axis: "x" | "y", [low, high]: Range, unit: string, most = 5): Partial<Axes> {
  if (unit === "rad") return {};
  const steps = [1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1, 5, 10, 15, 30, 45, 90, 180, 360, 720, 1440, 3600];
  const degrees = 180 / Math.PI;
  const span = (high - low) * degrees;
  const step = steps.find((it) => span / it <= most) ?? 3600 * 2 ** Math.ceil(Math.log2(span / most / 3600));
  const made = multiples(step, [low * degrees, high * degrees]).map((it): [number, string] => [it / degrees, `${Number(it.toPrecision(6))}°`.replace("-", "−")]);
  return axis === "x" ? { xTicks: made } : { yTicks: made };
}

function tenTo(power: number): string {
  const letters = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return power === 0 ? "1" : `10${power < 0 ? "⁻" : ""}${Array.from(String(Math.abs(power)), (digit) => letters[Number(digit)]).join("")}`;
}

function seconds(value: number): string {
  return Number.isFinite(value) && value > 0 ? `${digits(value, 6)} s` : words.none;
}
