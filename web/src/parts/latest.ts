// Only the newest of several questions counts: a question about values that have changed since need not be answered.

/** How long an older question may go on before it is ended for a newer one, in milliseconds. */
const PATIENCE = 400;

/** Why work ends early: the reader wants what is done, or something else. */
const [STOPPED, REPLACED] = ["stopped", "replaced"];

/** Whether what was done until then is wanted. */
export function isWanted(signal: AbortSignal): boolean {
  return !signal.aborted || signal.reason === STOPPED;
}

/** Work of which only the newest is wanted. */
export class Latest {
  #running: AbortController | undefined;
  #waiting: ((signal: AbortSignal) => Promise<void>) | undefined;

  /** Begins the work, or does so when the work before it has ended. */
  run(work: (signal: AbortSignal) => Promise<void>): void {
    this.#waiting = work;
    const running = this.#running;
    if (running === undefined) void this.#next();
    else setTimeout(() => running.abort(REPLACED), PATIENCE);
  }

  /** Ends what runs, and forgets what waits. */
  stop(): void {
    this.#waiting = undefined;
    this.#running?.abort(STOPPED);
  }

  async #next(): Promise<void> {
    while (this.#waiting !== undefined) {
      const work = this.#waiting;
      this.#waiting = undefined;
      this.#running = new AbortController();
      try {
        await work(this.#running.signal);
      } finally {
        this.#running = undefined;
      }
    }
  }
}
