// The time of the motion: running, slowly or backwards, paused, stepped.

export class Clock {
  time = 0;
  /** Time of the motion per real time; negative runs backwards. */
  speed = 1;
  #running = false;
  #last: number | undefined;
  #frame = 0;
  readonly #ticked: () => void;

  /** `ticked` is called before each frame while the time runs. */
  constructor(ticked: () => void) {
    this.#ticked = ticked;
  }

  get isRunning(): boolean {
    return this.#running;
  }

  run(): void {
    if (this.#running) return;
    this.#running = true;
    this.#last = undefined;
    this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  stop(): void {
    this.#running = false;
    cancelAnimationFrame(this.#frame);
  }

  #tick(now: number): void {
    /** Longest interval between frames, in milliseconds: longer pauses, such as those of a hidden page, are skipped. */
    const LONGEST = 250;
    const elapsed = Math.min(now - (this.#last ?? now), LONGEST);
    this.#last = now;
    this.time = Math.max(0, this.time + (elapsed / 1000) * this.speed);
    this.#ticked();
    if (this.#running) this.#frame = requestAnimationFrame((next) => this.#tick(next));
  }
}
