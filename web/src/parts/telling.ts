// An engine whose queries report their progress.

import type { Engine } from "../engine/engine.ts";
import type { Status } from "./status.ts";

/** The same engine; the status line shows the progress of its queries. */
export function telling(engine: Engine, status: Status): Engine {
  return {
    ask: (question) => engine.ask({ ...question, onProgress: (howFar) => status.progress(howFar) }),
    worker: () => engine.worker(),
  };
}
