// The periodic orbit at the chosen value, near the initial state or approached from it.

import type { Engine } from "../../engine/engine.ts";
import type { Command } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import { Finding } from "../../parts/layout.ts";
import { digits } from "../../parts/numbers.ts";
import { Picture } from "../../parts/picture.ts";
import { SavedNumbers } from "../../parts/saved_numbers.ts";
import { text } from "../../texts/en.ts";
import { said } from "./said.ts";

const words = text.chaos;

/** The result of `libration orbit`. */
interface Orbit {
  readonly period_s: number;
  readonly stability: string | null;
  /** Real and imaginary parts. */
  readonly multipliers: readonly (readonly [number, number])[];
}

export class OrbitFinding {
  readonly element: HTMLElement;
  readonly #picture: Picture;
  readonly #finding: Finding;
  readonly #numbers: SavedNumbers;

  constructor(engine: Engine) {
    this.#picture = new Picture(engine, "orbit");
    this.#numbers = new SavedNumbers(engine, "orbit");
    this.#finding = new Finding(words.orbit, this.#picture.element, this.#numbers.element, this.#numbers.table.element);
    this.element = this.#finding.element;
  }

  async find(command: Command, signal: AbortSignal): Promise<void> {
    const { answer, value } = await this.#picture.read<Orbit>(command, signal);
    if (signal.aborted) return;
    this.#numbers.offer(value === undefined ? undefined : command);
    if (value === undefined) {
      this.#picture.clear();
      return this.#finding.show(element("p", { class: "quiet" }, said(answer)));
    }
    this.#finding.show(element("p", {}, inWords(value)));
  }

  clear(): void {
    this.#finding.show();
    this.#picture.clear();
    this.#numbers.offer(undefined);
  }
}

function inWords({ period_s, stability, multipliers }: Orbit): string {
  const found = multipliers.filter(([, imaginary]) => imaginary >= 0).map(multiplier);
  const sentences = [words.period(digits(period_s, 9)), words.stability[stability ?? ""] ?? "", found.length > 0 ? words.multipliers(found.join(", ")) : ""];
  return sentences.filter((sentence) => sentence !== "").join(" ");
}

function multiplier([real, imaginary]: readonly [number, number]): string {
  return imaginary === 0 ? digits(real) : words.multiplier(digits(real), digits(imaginary));
}
