// The time of an ensemble: as fast as the clock if the machine can, and never ahead of the computation.

import type { Fleet, Frame } from "./fleet.ts";

/** One step by hand, in s. */
const STEP = 1 / 30;
/** Longest time between two frames, in s of the clock; longer delays are skipped. */
const LONGEST = 0.1;
/** Step on the way to a distant time, in s. */
const STRIDE = 0.1;

export interface Pace {
  readonly pictures: number;
  /** Time of the motion per time of the clock. */
  readonly pace: number;
}

export class Player {
  speed = 1;
  #time = 0;
  /** The last time that was requested. */
  #asked = 0;
  #running = false;
  #playing = false;
  #leaving = false;
  #busy: Promise<void> = Promise.resolve();
  #measured: { at: number; time: number; pictures: number } = { at: 0, time: 0, pictures: 0 };
  readonly #fleet: Fleet;
  readonly #shown: (frame: Frame) => void;
  readonly #kept: (frame: Frame) => void;
  readonly #failed: (reason: string) => void;

  /** `shown` receives the ensemble before each frame, `kept` at each period of its drive, `failed` the reason why it ends. */
  constructor(fleet: Fleet, shown: (frame: Frame) => void, kept: (frame: Frame) => void, failed: (reason: string) => void) {
    [this.#fleet, this.#shown, this.#kept, this.#failed] = [fleet, shown, kept, failed];
  }

  get isRunning(): boolean {
    return this.#running;
  }

  /** `true` if the time follows the clock, and not a request. */
  get isPlaying(): boolean {
    return this.#playing;
  }

  get time(): number {
    return this.#time;
  }

  run(): void {
    if (this.#running) return;
    this.#running = this.#playing = true;
    this.#measured = { at: performance.now(), time: this.#time, pictures: 0 };
    this.#then(() => this.#play());
  }

  /** Resolves when the last frame is shown. */
  pause(): Promise<void> {
    this.#running = this.#playing = false;
    return this.#busy;
  }

  step(): Promise<void> {
    return this.goTo(this.#time + STEP * this.speed);
  }

  /** Shows the ensemble at a time that is not before the current one, and at times on the way, unless it is paused. */
  goTo(time: number, onTheWay: (time: number) => void = () => {}): Promise<void> {
    return this.#then(async () => {
      this.#running = true;
      do {
        const next = Math.min(time, this.#time + STRIDE);
        this.#show(await this.#at(next));
        onTheWay(this.#time);
      } while (this.#time < time && this.#running && !this.#leaving);
      this.#running = false;
    });
  }

  /** The pace since the last call. */
  pace(): Pace | undefined {
    const now = performance.now();
    const { at, time, pictures } = this.#measured;
    const seconds = (now - at) / 1000;
    if (seconds < 1) return undefined;
    this.#measured = { at: now, time: this.#time, pictures: 0 };
    return { pictures: Math.round(pictures / seconds), pace: (this.#time - time) / seconds };
  }

  close(): void {
    [this.#leaving, this.#running] = [true, false];
    this.#fleet.close();
  }

  #then(work: () => Promise<void>): Promise<void> {
    const done = this.#busy.then(() => (this.#leaving ? undefined : work()));
    this.#busy = done.catch((error: unknown) => {
      this.#running = this.#playing = false;
      this.#failed(error instanceof Error ? error.message : String(error));
    });
    return this.#busy;
  }

  // The next frame is computed while a frame is drawn.
  async #play(): Promise<void> {
    let last = await picture();
    let next = this.#at(this.#time);
    while (!this.#leaving) {
      const frame = await next;
      const now = performance.now();
      const ahead = this.#running;
      if (ahead) next = this.#at(frame.time + Math.min((now - last) / 1000, LONGEST) * this.speed);
      last = now;
      this.#show(frame);
      if (!ahead) return;
      await picture();
    }
  }

  /** The ensemble at a time, after each period of the drive on the way. */
  async #at(time: number): Promise<Frame> {
    const { period } = this.#fleet.facts;
    if (Number.isFinite(period)) {
      for (let n = Math.floor(this.#asked / period) + 1; n * period <= time; n++) this.#kept(await this.#fleet.at(n * period));
    }
    this.#asked = time;
    return this.#fleet.at(time);
  }

  #show(frame: Frame): void {
    this.#time = frame.time;
    this.#measured.pictures += 1;
    this.#shown(frame);
  }
}

function picture(): Promise<number> {
  return new Promise((resolve) => requestAnimationFrame(resolve));
}
