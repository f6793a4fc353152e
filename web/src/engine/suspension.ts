// A function of the page that the module waits for, where the browser lets it wait: meanwhile the worker hears what it is told.

type Function = (...values: never[]) => unknown;

/** As browsers have it that know of it; TypeScript does not yet. */
interface Suspending {
  readonly Suspending?: new (waited: Function) => Function;
  readonly promising?: (waits: Function) => Function;
}

const { Suspending, promising } = WebAssembly as unknown as Suspending;

/** Whether the browser knows of it. */
export const canWait = Suspending !== undefined && promising !== undefined;

/** The function as the module is given it; where it cannot wait, one that has a value at once. */
export function waitedFor(wait: () => Promise<number>, atOnce: number): Function {
  return Suspending === undefined || !canWait ? () => atOnce : new Suspending(wait);
}

/** A function of the module that may wait: its result is a promise, where it can. */
export function waiting(of: () => number): () => Promise<number> | number {
  return promising === undefined || !canWait ? of : (promising(of) as () => Promise<number>);
}

/** Lets whatever has come in meanwhile be heard. */
export function pause(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(undefined);
  });
}
