// A motion as the room shows it: known at every time, exactly or by integration.

import type { Mathematics } from "../../engine/mathematics.ts";

/** Angles in rad, unwrapped, and velocities in rad/s at evenly spaced times. */
export interface Samples {
  readonly angles: Float64Array;
  readonly velocities: Float64Array;
}

export interface Place {
  readonly angle: number;
  readonly velocity: number;
  /** π − |angle in the turn|. */
  readonly complement: number;
  readonly turns: number;
}

export interface Course {
  /** `undefined` if the motion is not known yet. */
  at(time: number): Place | undefined;
  samples(first: number, step: number, count: number): Samples;
}

/** The exact solution, at any time, independently of earlier times. */
export class ExactCourse implements Course {
  readonly #mathematics: Mathematics;

  constructor(mathematics: Mathematics) {
    this.#mathematics = mathematics;
  }

  at(time: number): Place {
    return this.#mathematics.state(time);
  }

  samples(first: number, step: number, count: number): Samples {
    return this.#mathematics.states(first, step, count);
  }
}

/** An integrated motion, at times `step` apart from zero on; between them by cubic interpolation of angles and velocities. */
export class IntegratedCourse implements Course {
  readonly #step: number;
  readonly #known: Samples;

  constructor(step: number, known: Samples) {
    [this.#step, this.#known] = [step, known];
  }

  /** The last known time. */
  get end(): number {
    return (this.#known.angles.length - 1) * this.#step;
  }

  at(time: number): Place | undefined {
    const { angles, velocities } = this.#known;
    const begin = Math.min(Math.floor(time / this.#step), angles.length - 2);
    const [a, b] = [angles[begin], angles[begin + 1]];
    const [v, w] = [velocities[begin], velocities[begin + 1]];
    if (time > this.end || a === undefined || b === undefined || v === undefined || w === undefined) return undefined;
    const h = this.#step;
    const s = time / h - begin;
    const [rise, left, right] = [b - a, v * h, w * h];
    const angle = a + s * (left + s * (3 * rise - 2 * left - right + s * (left + right - 2 * rise)));
    const velocity = (left + s * (2 * (3 * rise - 2 * left - right) + 3 * s * (left + right - 2 * rise))) / h;
    const turns = Math.round(angle / (2 * Math.PI));
    return { angle, velocity, complement: Math.PI - Math.abs(angle - 2 * Math.PI * turns), turns };
  }

  samples(first: number, step: number, count: number): Samples {
    const places = Array.from({ length: count }, (_, n) => this.at(first + n * step));
    return {
      angles: Float64Array.from(places, (place) => place?.angle ?? NaN),
      velocities: Float64Array.from(places, (place) => place?.velocity ?? NaN),
    };
  }
}
