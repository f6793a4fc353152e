// A photogate at the lowest point: the times at which the bob passes it, and the time of whole swings.

import { button, element } from "../../parts/element.ts";
import { choiceField, textField } from "../../parts/field.ts";
import { text } from "../../texts/en.ts";
import type { Course } from "./course.ts";

const words = text.pendulum.instruments.gate;

/** Largest number of samples in one search; between two frames there are few passages. */
const SAMPLES = 4000;

/** Times within an interval at which the bob passes the lowest point, each from the motion itself by bisection. */
export function passages(course: Course, from: number, to: number, smallAnglePeriod: number): number[] {
  const count = Math.min(SAMPLES, 2 + Math.ceil((16 * (to - from)) / smallAnglePeriod));
  const step = (to - from) / (count - 1);
  const turns = Array.from(course.samples(from, step, count).angles, turnOf);
  const found: number[] = [];
  for (let n = 1; n < count; n++) {
    const [before, after] = [turns[n - 1] ?? NaN, turns[n] ?? NaN];
    if (Number.isFinite(before + after) && before !== after) found.push(passage(course, from + (n - 1) * step, from + n * step, before));
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
  #times: number[] = [];
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
    this.#times = [];
    this.#reading.textContent = "–";
    this.#into.disabled = true;
    this.#show();
  }

  /** Follows the motion to a time; going back starts afresh. */
  follow(course: Course, time: number, smallAnglePeriod: number): void {
    if (time < this.#last) this.clear();
    else if (time > this.#last) {
      const found = passages(course, this.#last, time, smallAnglePeriod);
      for (const it of found) this.#pass(it);
      if (found.length > 0) this.#show();
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

  #pass(time: number): void {
    if (this.#wanted === 0) return;
    this.#times.push(time);
    if (this.#times.length !== 2 * this.#wanted + 1) return;
    this.#reading.textContent = `${(time - (this.#times[0] ?? time)).toFixed(Number(this.#resolution.value))} s`;
    this.#into.disabled = false;
    // The passage that ends a measurement begins the next one.
    this.#times = [time];
  }

  #show(): void {
    this.#count.textContent = this.#wanted === 0 ? "" : words.passages(this.#times.length, 2 * this.#wanted + 1);
  }
}
