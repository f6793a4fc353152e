// An engine whose questions say how far they are.

import type { Engine } from "../engine/engine.ts";
import type { Status } from "./status.ts";

/** The same engine; the line of status shows how far its questions are. */
export function telling(engine: Engine, status: Status): Engine {
  return {
    ask: (question) => engine.ask({ ...question, onProgress: (howFar) => status.progress(howFar) }),
    worker: () => engine.worker(),
  };
}
