// A photogate at the lowest point: the times at which the bob passes it, and the time of whole swings.

import { button, element } from "../../parts/element.ts";
import { choiceField, textField } from "../../parts/field.ts";
import { text } from "../../texts/en.ts";
import type { Course } from "./course.ts";

const words = text.pendulum.instruments.gate;

/** Largest number of samples in one search; between two frames there are few passages. */
const SAMPLES = 4000;

/** A passage of the lowest point: its time, and 1 for growing angles or −1. */
interface Passage {
  readonly time: number;
  readonly direction: number;
}

/** The passages within an interval, each from the motion itself by bisection; `undefined` if the motion is too fast to be followed. */
function passages(course: Course, from: number, to: number, fastestPeriod: number): Passage[] | undefined {
  const count = 2 + Math.ceil((16 * (to - from)) / fastestPeriod);
  if (!(count <= SAMPLES)) return undefined;
  const step = (to - from) / (count - 1);
  const turns = Array.from(course.samples(from, step, count).angles, turnOf);
  const found: Passage[] = [];
  for (let n = 1; n < count; n++) {
    const [before, after] = [turns[n - 1] ?? NaN, turns[n] ?? NaN];
    if (Number.isFinite(before + after) && before !== after) {
      found.push({ time: passage(course, from + (n - 1) * step, from + n * step, before), direction: Math.sign(after - before) });
    }
  }
  return found;
}

/** The number of lowest points between the angle and that of rest: it changes where the bob passes one. */
function turnOf(angle: number): number {
  return Math.floor(angle / (2 * Math.PI));
}

function passage(course: Course, from: number, to: number, before: number): number {
  let [low, high] = [from, to];
  for (let n = 0; n < 60 && high > low; n++) {
    const middle = (low + high) / 2;
    if (turnOf(course.at(middle)?.angle ?? NaN) === before) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

export class Gate {
  readonly element: HTMLElement;
  readonly #reading = element("output", { class: "display" }, "–");
  readonly #count = element("span", { class: "quiet" });
  readonly #swings = textField({ key: "swings", words: { label: words.swings }, initial: "1" });
  readonly #resolution = choiceField({ key: "resolution", words: { label: words.resolution }, initial: "3" }, words.resolutions.map(([value = "", name = ""]) => [value, name] as const));
  readonly #into: HTMLButtonElement;
  /** The passages in the direction of the first one: one for each period, in swings and in rotations. */
  #passed: Passage[] = [];
  #last = 0;

  /** `into` is called with the time of a number of swings, as displayed, for the table. */
  constructor(into: (swings: number, seconds: string) => void) {
    this.#into = button(words.into, () => into(this.#wanted, this.#reading.textContent.replace(" s", "")), { disabled: true });
    this.element = element("div", { class: "card", role: "group", "aria-label": words.title }, element("h2", {}, words.title), this.#reading, this.#count, this.#swings.element, this.#resolution.element, this.#into);
    for (const field of [this.#swings, this.#resolution]) field.onChange(() => this.clear());
    this.#swings.onChange(() => this.#swings.refuse(this.#wanted > 0 ? "" : text.pendulum.instruments.stopwatch.wrongSwings));
  }

  /** `true` if the beam is interrupted now. */
  isBroken(angle: number): boolean {
    return Math.abs(Math.sin(angle / 2)) < 0.04;
  }

  clear(): void {
    this.#passed = [];
    this.#reading.textContent = "–";
    this.#into.disabled = true;
    this.#show();
  }

  /** Follows the motion to a time; going back starts afresh. No period is shorter than the fastest one. */
  follow(course: Course, time: number, fastestPeriod: number): void {
    if (time < this.#last) this.clear();
    else if (time > this.#last) {
      const found = passages(course, this.#last, time, fastestPeriod);
      if (found === undefined) this.clear();
      for (const it of found ?? []) this.#pass(it);
      if (found?.length !== 0) this.#show();
    }
    this.#last = time;
  }

  /** Begins at a time, without passages before it. */
  begin(time: number): void {
    this.#last = time;
    this.clear();
  }

  /** The number of swings to be timed; zero if the entry is wrong. */
  get #wanted(): number {
    const wanted = Number(this.#swings.value);
    return Number.isInteger(wanted) && wanted > 0 && wanted < 1000 ? wanted : 0;
  }

  #pass(passage: Passage): void {
    const first = this.#passed[0] ?? passage;
    if (this.#wanted === 0 || passage.direction !== first.direction) return;
    this.#passed.push(passage);
    if (this.#passed.length !== this.#wanted + 1) return;
    this.#reading.textContent = `${(passage.time - first.time).toFixed(Number(this.#resolution.value))} s`;
    this.#into.disabled = false;
    // The passage that ends a measurement begins the next one.
    this.#passed = [passage];
  }

  #show(): void {
    this.#count.textContent = this.#wanted === 0 ? "" : words.counted(Math.max(0, this.#passed.length - 1), this.#wanted);
  }
}
