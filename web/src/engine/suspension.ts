// A function of the page that the module waits for, if the browser supports that: meanwhile the worker receives messages.

type Function = (...values: never[]) => unknown;

/** The interface of browsers that support it; TypeScript does not declare it yet. */
interface Suspending {
  readonly Suspending?: new (waited: Function) => Function;
  readonly promising?: (waits: Function) => Function;
}

const { Suspending, promising } = WebAssembly as unknown as Suspending;

/** `true` if the browser supports suspension. */
export const canWait = Suspending !== undefined && promising !== undefined;

/** The function as it is passed to the module; if the module cannot wait, one that returns a value at once. */
export function waitedFor(wait: () => Promise<number>, atOnce: number): Function {
  return Suspending === undefined || !canWait ? () => atOnce : new Suspending(wait);
}

/** A function of the module that may wait: its result is a promise if it can. */
export function waiting(of: () => number): () => Promise<number> | number {
  return promising === undefined || !canWait ? of : (promising(of) as () => Promise<number>);
}

/** Lets pending messages be handled. */
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
