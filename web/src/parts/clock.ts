// The time of the motion: runs, slowly or backwards, stands, steps.

export class Clock {
  time = 0;
  /** Of the motion's time in real time; negative runs backwards. */
  speed = 1;
  #running = false;
  #last: number | undefined;
  #frame = 0;
  readonly #ticked: () => void;

  /** `ticked` is called before each picture while the time runs. */
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
    /** Longer pauses, of a page that was out of sight, are not made up for, in milliseconds. */
    const LONGEST = 250;
    const elapsed = Math.min(now - (this.#last ?? now), LONGEST);
    this.#last = now;
    this.time = Math.max(0, this.time + (elapsed / 1000) * this.speed);
    this.#ticked();
    if (this.#running) this.#frame = requestAnimationFrame((next) => this.#tick(next));
  }
}
