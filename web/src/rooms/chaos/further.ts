// Findings with fields of their own: responses over a parameter, stability over two, Melnikov's thresholds, the exchange between modes.

import type { Engine } from "../../engine/engine.ts";
import type { Command } from "../../parts/command.ts";
import type { Form } from "../../parts/form.ts";
import { text } from "../../texts/en.ts";
import { Asked, type Further } from "./asked.ts";
import { exchange } from "./exchange.ts";
import { PARTS } from "./fields.ts";
import { maps } from "./maps.ts";
import { melnikov } from "./melnikov.ts";
import type { Questions } from "./questions.ts";
import { responses } from "./responses.ts";

const words = text.chaos;

export class FurtherFindings {
  readonly elements: readonly HTMLElement[];
  readonly fields: readonly HTMLElement[];
  /** All findings, those that take longest last. */
  readonly #all: readonly (readonly [finding: Further, command: () => Command | undefined])[];

  constructor(engine: Engine, form: Form, questions: Questions) {
    this.#all = [
      [new Asked(engine, form, melnikov), () => questions.thresholds()],
      [new Asked(engine, form, exchange), () => questions.exchange()],
      [new Asked(engine, form, responses), () => questions.response()],
      [new Asked(engine, form, maps), () => questions.map()],
    ];
    this.elements = this.#all.map(([{ element }]) => element);
    const part = (name: "response" | "map" | "melnikov" | "exchange") => form.part(words.further[name], PARTS[name], { folded: true });
    this.fields = [part("response"), part("map"), part("melnikov"), part("exchange")];
  }

  commands(): Command[] {
    return this.#all.map(([, command]) => command()).filter((command) => command !== undefined);
  }

  /** Shows the places of the queried results. */
  expect(): void {
    for (const [finding, command] of this.#all) finding.expect(command());
  }

  async find(signal: AbortSignal): Promise<void> {
    for (const [finding, command] of this.#all) {
      if (signal.aborted) return;
      await finding.find(command(), signal);
    }
  }

  clear(): void {
    for (const [finding] of this.#all) finding.clear();
  }
}
