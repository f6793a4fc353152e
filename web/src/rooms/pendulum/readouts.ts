// The numbers that are read from a distance: amplitude, period, length, gravity, time.

import type { Motion } from "../../engine/mathematics.ts";
import { element } from "../../parts/element.ts";
import { angle as angleInWords, digits, short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.readouts;
const KEYS = ["period", "amplitude", "length", "gravity", "time"] as const;
type Key = (typeof KEYS)[number];

export class Readouts {
  readonly element: HTMLElement;
  readonly #values = new Map<Key, HTMLElement>();

  constructor() {
    const all = KEYS.map((key) => {
      const value = element("strong", {}, "–");
      this.#values.set(key, value);
      return element("p", { class: `readout ${key}` }, element("span", {}, words[key]), " ", value);
    });
    this.element = element("div", { class: "readouts", role: "group", "aria-label": words.group }, ...all);
  }

  /** Shows the constants of the motion; those that are hidden from the class are question marks. */
  show(motion: Motion, length: number, gravity: number, isExact: boolean, unit: string, isHidden: (key: "period" | "length" | "gravity") => boolean): void {
    const swings = motion.period > 0;
    this.#set("period", isHidden("period") ? "?" : !isExact ? "–" : !swings ? "–" : Number.isFinite(motion.period) ? `${digits(motion.period, 5)} s` : "∞");
    this.#set("amplitude", isExact && motion.amplitude > 0 ? angleInWords(motion.amplitude, unit, 5) : "–");
    this.#set("length", isHidden("length") ? "?" : `${short(length, 4)} m`);
    this.#set("gravity", isHidden("gravity") ? "?" : `${short(gravity, 4)} m/s²`);
  }

  now(time: number): void {
    this.#set("time", `${time.toFixed(2)} s`);
  }

  #set(key: Key, value: string): void {
    const place = this.#values.get(key);
    if (place !== undefined && place.textContent !== value) place.textContent = value;
  }
}
