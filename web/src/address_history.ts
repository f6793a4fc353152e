// Former states of a room, for undo and redo. Changes of one control that follow each other closely, such as those of a slider, are one step.

/** Longest pause between two changes of one step, in milliseconds, and most steps. */
const [PAUSE, MOST] = [700, 200];

export class AddressHistory {
  #past: string[] = [];
  #future: string[] = [];
  #changedAt = -Infinity;
  readonly #watchers = new Set<() => void>();

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Calls back after each change; returns a function that ends that. */
  watch(changed: () => void): () => void {
    this.#watchers.add(changed);
    return () => this.#watchers.delete(changed);
  }

  /** Remembers the state before a change. */
  remember(before: string): void {
    const now = performance.now();
    if (now - this.#changedAt > PAUSE) this.#past = [...this.#past.slice(1 - MOST), before];
    [this.#changedAt, this.#future] = [now, []];
    this.#tell();
  }

  /** Lets the next change begin a step, whatever the pause. */
  endStep(): void {
    this.#changedAt = -Infinity;
  }

  /** The state before the present one, which becomes the next one of `redo`. */
  undo(present: string): string | undefined {
    return this.#step(this.#past, this.#future, present);
  }

  redo(present: string): string | undefined {
    return this.#step(this.#future, this.#past, present);
  }

  clear(): void {
    [this.#past, this.#future] = [[], []];
    this.endStep();
    this.#tell();
  }

  #step(from: string[], to: string[], present: string): string | undefined {
    const state = from.pop();
    if (state !== undefined) to.push(present);
    this.endStep();
    this.#tell();
    return state;
  }

  #tell(): void {
    for (const changed of this.#watchers) changed();
  }
}
