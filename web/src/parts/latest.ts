// Only the newest of several queries counts: a query about values that have changed since can be dropped.

/** Time that an older query may continue before it is cancelled for a newer one, in milliseconds. */
const PATIENCE = 400;

/** The reasons for a cancellation: the reader wants the partial results, or other ones. */
const [STOPPED, REPLACED] = ["stopped", "replaced"];

/** `true` if the partial results are wanted. */
export function isWanted(signal: AbortSignal): boolean {
  return !signal.aborted || signal.reason === STOPPED;
}

/** Work of which only the newest is wanted. */
export class Latest {
  #running: AbortController | undefined;
  #waiting: ((signal: AbortSignal) => Promise<void>) | undefined;

  /** Begins the work, now or when the work before it has ended. */
  run(work: (signal: AbortSignal) => Promise<void>): void {
    this.#waiting = work;
    const running = this.#running;
    if (running === undefined) void this.#next();
    else setTimeout(() => running.abort(REPLACED), PATIENCE);
  }

  /** Cancels the running work, and drops the waiting work. */
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
