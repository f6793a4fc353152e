// The engine that runs queries in a worker, so that the page never freezes: started with the first query, and restarted after a fault or a cancellation.

import { text as texts } from "../texts/en.ts";
import { type Answer, type Engine, plainError, type Question } from "./engine.ts";
import { text as moduleText } from "./module.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";
import { canWait } from "./suspension.ts";

/** The source of the worker, as bundled by `web/build`. */
declare const WORKER_SOURCE: string;

const INTERRUPTED = 130;
/** Time in which a cancelled query may write its partial results, in milliseconds. */
const PATIENCE = 1500;

export class WorkerEngine implements Engine {
  #module: WebAssembly.Module | undefined;
  #worker: Worker | undefined;
  #last: Promise<unknown> = Promise.resolve();

  ask(question: Question): Promise<Answer> {
    const answer = this.#last.then(() => this.#answered(question));
    this.#last = answer.catch(() => undefined);
    return answer;
  }

  async #answered(question: Question): Promise<Answer> {
    const { signal } = question;
    if (signal?.aborted) return ended(INTERRUPTED, [], texts.engine.endedEarly);
    const worker = await this.#ready();
    return new Promise((resolve) => {
      const chunks: Uint8Array[] = [];
      let ending: ReturnType<typeof setTimeout> | undefined;
      const close = (answer: Answer, restart: boolean) => {
        clearTimeout(ending);
        signal?.removeEventListener("abort", abort);
        worker.onmessage = worker.onerror = null;
        if (restart) this.#end();
        resolve(answer);
      };
      // If the browser delivers the message to the worker, the result is what the command writes when it is interrupted.
      const abort = () => {
        if (!canWait) return close(ended(INTERRUPTED, chunks, texts.engine.endedEarly), true);
        worker.postMessage({ kind: "stop" } satisfies ToWorker);
        ending = setTimeout(() => close(ended(INTERRUPTED, chunks, texts.engine.endedEarly), true), PATIENCE);
      };
      const fault = (reason: string) => close(ended(1, chunks, texts.engine.fault(reason)), true);
      signal?.addEventListener("abort", abort);
      worker.onerror = (event) => fault(event.message);
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
        switch (data.kind) {
          case "output":
            chunks.push(data.chunk);
            return question.onOutput?.(data.chunk);
          case "note":
            return question.onNote?.(data.line);
          case "progress":
            return question.onProgress?.(data.howFar);
          case "end":
            return close({ ...data, output: joined(chunks) }, false);
          case "fault":
            return fault(data.reason);
        }
      };
      const files = question.files ?? new Map();
      worker.postMessage({ kind: "question", words: question.words, files } satisfies ToWorker);
    });
  }

  async worker(): Promise<Worker> {
    const worker = begun(this.#module === undefined ? { kind: "text", text: await moduleText("whole") } : { kind: "module", module: this.#module });
    worker.addEventListener("message", ({ data }: MessageEvent<FromWorker>) => {
      if (data.kind === "module") this.#module = data.module;
    });
    return worker;
  }

  async #ready(): Promise<Worker> {
    return (this.#worker ??= await this.worker());
  }

  #end(): void {
    this.#worker?.terminate();
    this.#worker = undefined;
  }
}

function begun(first: ToWorker): Worker {
  const source = URL.createObjectURL(new Blob([WORKER_SOURCE], { type: "text/javascript" }));
  const worker = new Worker(source);
  URL.revokeObjectURL(source);
  worker.postMessage(first);
  return worker;
}

function ended(status: number, chunks: readonly Uint8Array[], reason: string): Answer {
  return { status, output: joined(chunks), error: plainError(reason), files: new Map() };
}

function joined(chunks: readonly Uint8Array[]): Uint8Array {
  const all = new Uint8Array(chunks.reduce((length, chunk) => length + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}
