// A second pendulum at the same pivot, released together with the first, under the same friction.

import type { Engine } from "../../engine/engine.ts";
import { Mathematics, type Motion } from "../../engine/mathematics.ts";
import { type Course, ExactCourse } from "./course.ts";
import type { Drawn } from "./drawing.ts";
import { type Forces, integrated } from "./integration.ts";

/** Its settings, as entered, and its mass in kilograms. */
export interface SecondSettings {
  readonly angle: string;
  readonly length: string;
  readonly gravity: string;
}

export class Second {
  #mathematics: Mathematics | undefined;
  #course: Course | undefined;
  #length = 1;
  #frequency = 1;

  /** Launches it from rest; returns the key of a setting that is wrong, with the reason. */
  async launch(settings: SecondSettings): Promise<Motion | { readonly quantity: string; readonly error: string }> {
    this.#course = undefined;
    const mathematics = (this.#mathematics ??= await Mathematics.load());
    const angle = mathematics.angle(settings.angle);
    if ("error" in angle) return { quantity: "angle", error: angle.error };
    const [length, gravity] = [mathematics.length(settings.length), mathematics.acceleration(settings.gravity)];
    if ("error" in length) return { quantity: "length", error: length.error };
    if ("error" in gravity) return { quantity: "gravity", error: gravity.error };
    const motion = mathematics.launch(settings.angle, 0, length.value, gravity.value);
    if ("error" in motion) return motion;
    [this.#length, this.#frequency] = [length.value, motion.angularFrequency];
    return motion;
  }

  /** Follows the exact motion. */
  follow(): void {
    if (this.#mathematics !== undefined) this.#course = new ExactCourse(this.#mathematics);
  }

  /** Follows the motion under these forces, as far as it is integrated. */
  async integrate(engine: Engine, forces: Forces, angle: string, until: number, signal: AbortSignal): Promise<void> {
    const its = { ...forces, angle, velocity: 0, angularFrequency: this.#frequency };
    const course = await integrated(engine, its, until, signal);
    if (!signal.aborted && !("error" in course)) this.#course = course;
  }

  clear(): void {
    this.#course = undefined;
  }

  /** Its motion, as far as it is known; `undefined` if there is none. */
  get course(): Course | undefined {
    return this.#course;
  }

  /** The pendulum at a time; `undefined` if there is none, or it is not known as far. */
  drawn(time: number, bob: number, trace: (course: Course) => ArrayLike<number>): Drawn | undefined {
    const place = this.#course?.at(time);
    if (place === undefined || this.#course === undefined) return undefined;
    return { angle: place.angle, velocity: place.velocity, length: this.#length, colour: "curve-4", bob, fastest: 2 * this.#frequency, trace: trace(this.#course) };
  }
}
