// The small module: the exact motion of the pendulum, computed synchronously and without a worker.

import { instantiated } from "./fused.ts";
import { text } from "./module.ts";

interface Exports {
  readonly memory: WebAssembly.Memory;
  room(length: number): number;
  numbers(): number;
  numbers_count(): number;
  text(): number;
  text_length(): number;
  angle(): number;
  length(): number;
  acceleration(): number;
  angular_velocity(): number;
  launch(length: number, gravity: number, velocity: number): number;
  state(time: number): number;
  states(first: number, step: number, count: number): number;
  approximation(place: number, first: number, step: number, count: number): number;
  harmonics(tolerance: number, limit: number): number;
}

/** The value of a text, or the reason why it has none, in the library's words. */
export type Reading = { readonly value: number } | { readonly error: string };

export interface AngleReading {
  readonly radians: number;
  /** Within [−π, π]. */
  readonly inTurn: number;
  /** π − |angle in the turn|, exact even if it is small. */
  readonly complement: number;
  readonly turns: number;
}

export type Regime = "rest" | "upright" | "libration" | "separatrix" | "rotation";
const REGIMES: readonly Regime[] = ["rest", "upright", "libration", "separatrix", "rotation"];

/** Facts of a motion, in SI units and radians; NaN for those that do not exist. */
export interface Motion {
  readonly regime: Regime;
  readonly period: number;
  readonly smallAnglePeriod: number;
  readonly amplitude: number;
  readonly complement: number;
  /** Energy over that of the pendulum at rest upright. */
  readonly energyRatio: number;
  readonly energyExcess: number;
  readonly specificEnergy: number;
  readonly angularFrequency: number;
}

export interface State {
  readonly turns: number;
  readonly inTurn: number;
  readonly complement: number;
  readonly angle: number;
  readonly velocity: number;
}

export interface Harmonic {
  readonly n: number;
  readonly angle: number;
  readonly velocity: number;
}

export interface Harmonics {
  readonly fundamental: number;
  readonly meanVelocity: number;
  readonly epoch: number;
  readonly terms: readonly Harmonic[];
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** The mathematics of one pendulum; all methods refer to the motion launched last. */
export class Mathematics {
  readonly #module: Exports;

  private constructor(exports: Exports) {
    this.#module = exports;
  }

  static #compiled: Promise<WebAssembly.Module> | undefined;

  /** An instance of its own; the module is decompressed once. Compiled at once, it moves the pendulum before the browser has read the rest of the page. */
  static async load(): Promise<Mathematics> {
    return Mathematics.from(await (Mathematics.#compiled ??= text("pendulum").then((packed) => new WebAssembly.Module(unpack(packed)))));
  }

  static from(compiled: WebAssembly.Module): Mathematics {
    return new Mathematics(instantiated(compiled) as unknown as Exports);
  }

  angle(text: string): AngleReading | { readonly error: string } {
    this.#give(text);
    if (!this.#module.angle()) return { error: this.#text() };
    const [radians = NaN, inTurn = NaN, complement = NaN, turns = NaN] = this.#numbers();
    return { radians, inTurn, complement, turns };
  }

  length(text: string): Reading {
    return this.#quantity(text, () => this.#module.length());
  }

  acceleration(text: string): Reading {
    return this.#quantity(text, () => this.#module.acceleration());
  }

  angularVelocity(text: string): Reading {
    return this.#quantity(text, () => this.#module.angular_velocity());
  }

  /** The motion that passes this angle with this velocity in rad/s at t = 0; length in m, gravity in m/s². */
  launch(angle: string, velocity: number, length: number, gravity: number): Motion | { readonly quantity: string; readonly error: string } {
    this.#give(angle);
    if (!this.#module.launch(length, gravity, velocity)) {
      const [quantity = "angle", ...lines] = this.#text().split("\n");
      return { quantity, error: lines.join("\n") };
    }
    const [regime = 0, period = NaN, smallAnglePeriod = NaN, amplitude = NaN, complement = NaN, energyRatio = NaN, energyExcess = NaN, specificEnergy = NaN, angularFrequency = NaN] =
      this.#numbers();
    return { regime: REGIMES[regime] ?? "rest", period, smallAnglePeriod, amplitude, complement, energyRatio, energyExcess, specificEnergy, angularFrequency };
  }

  state(time: number): State {
    this.#module.state(time);
    const [turns = NaN, inTurn = NaN, complement = NaN, angle = NaN, velocity = NaN] = this.#numbers();
    return { turns, inTurn, complement, angle, velocity };
  }

  /** Unwrapped angles and velocities at times that are `step` apart. */
  states(first: number, step: number, count: number): { angles: Float64Array; velocities: Float64Array } {
    this.#module.states(first, step, count);
    const all = this.#numbers().slice();
    return { angles: all.subarray(0, all.length / 2), velocities: all.subarray(all.length / 2) };
  }

  /** Angles of an approximate motion, by its index in the catalogue; `undefined` if it does not apply to such an initial state. */
  approximation(place: number, first: number, step: number, count: number): Float64Array | undefined {
    return this.#module.approximation(place, first, step, count) ? this.#numbers().slice() : undefined;
  }

  harmonics(tolerance: number, limit: number): Harmonics {
    this.#module.harmonics(tolerance, limit);
    const [fundamental = NaN, meanVelocity = NaN, epoch = NaN, ...rest] = this.#numbers();
    const terms: Harmonic[] = [];
    for (let at = 0; at + 2 < rest.length; at += 3) {
      terms.push({ n: rest[at] ?? NaN, angle: rest[at + 1] ?? NaN, velocity: rest[at + 2] ?? NaN });
    }
    return { fundamental, meanVelocity, epoch, terms };
  }

  #quantity(text: string, read: () => number): Reading {
    this.#give(text);
    return read() ? { value: this.#numbers()[0] ?? NaN } : { error: this.#text() };
  }

  #give(text: string): void {
    const bytes = encoder.encode(text);
    const at = this.#module.room(bytes.length);
    new Uint8Array(this.#module.memory.buffer, at, bytes.length).set(bytes);
  }

  /** Valid until the next call. */
  #numbers(): Float64Array {
    return new Float64Array(this.#module.memory.buffer, this.#module.numbers(), this.#module.numbers_count());
  }

  #text(): string {
    return decoder.decode(new Uint8Array(this.#module.memory.buffer, this.#module.text(), this.#module.text_length()));
  }
}
