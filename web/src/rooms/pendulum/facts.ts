// Facts of the motion, in numbers.

import type { Motion } from "../../engine/mathematics.ts";
import { element } from "../../parts/element.ts";
import { angle as angleInWords, digits } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Place } from "./course.ts";

const words = text.pendulum.facts;

/** Distance from the top, in rad, below which the distance is shown instead of the angle. */
const NEAR = 1e-3;

export class Facts {
  readonly element: HTMLElement;
  readonly #motion = element("dl");
  readonly #now = element("dl", { class: "now" });
  #unit = "deg";

  constructor() {
    this.element = element("section", { class: "facts" }, element("h2", {}, words.title), this.#motion, element("h3", {}, words.now), this.#now);
  }

  /** Shows the facts of an exact motion; for damped and driven ones only those of the initial state. */
  show(motion: Motion, isExact: boolean, unit: string): void {
    this.#unit = unit;
    const period = Number.isFinite(motion.period) && motion.period > 0;
    fill(this.#motion, [
      [words.regime, isExact ? text.pendulum.regimes[motion.regime] : undefined],
      [words.period, isExact ? (period ? `${digits(motion.period, 12)} s` : "∞") : undefined],
      [words.ratio, isExact && period ? digits(motion.period / motion.smallAnglePeriod, 12) : undefined],
      [words.smallPeriod, `${digits(motion.smallAnglePeriod, 12)} s`],
      [words.amplitude, isExact && motion.amplitude > 0 ? angleInWords(motion.amplitude, unit, 12) : undefined],
      [words.complement, isExact && motion.complement < NEAR ? angleInWords(motion.complement, unit, 6) : undefined],
      [words.energy, isExact ? energy(motion) : undefined],
    ]);
  }

  /** Shows a moment, with the angle of a second pendulum if there is one. */
  now(time: number, place: Place, second: Place | undefined): void {
    fill(this.#now, [
      [words.time, `${time.toFixed(2)} s`],
      [words.angle, this.#angle(place)],
      [words.second, second && this.#angle(second)],
      [words.velocity, `${place.velocity.toFixed(3).replace("-", "−")} rad/s`],
      [words.turns, place.turns === 0 ? undefined : String(place.turns).replace("-", "−")],
      [words.toTop, place.complement < NEAR ? angleInWords(place.complement, this.#unit, 3) : undefined],
    ]);
  }

  #angle(place: Place): string {
    const written = this.#unit === "rad" ? `${wrapped(place).toFixed(4)} rad` : `${((180 / Math.PI) * wrapped(place)).toFixed(2)}°`;
    return written.replace("-", "−");
  }
}

function wrapped({ angle, turns }: Place): number {
  return angle - 2 * Math.PI * turns;
}

// Close to the separatrix the excess is more informative than the ratio.
function energy({ energyRatio, energyExcess }: Motion): string {
  const small = Math.abs(energyExcess) < 1e-6 && energyExcess !== 0;
  return small ? `1 ${energyExcess < 0 ? "−" : "+"} ${digits(Math.abs(energyExcess), 6)}` : digits(energyRatio, 12);
}

/** Texts are replaced one by one, so that a selection stays. */
function fill(list: HTMLElement, entries: readonly (readonly [string, string | undefined])[]): void {
  const shown = entries.filter((entry): entry is readonly [string, string] => entry[1] !== undefined);
  const names = shown.map(([name]) => name).join("\n");
  if (list.dataset["names"] !== names) {
    list.replaceChildren(...shown.flatMap(([name]) => [element("dt", {}, name), element("dd")]));
    list.dataset["names"] = names;
  }
  const values = list.querySelectorAll("dd");
  shown.forEach(([, value], n) => {
    const place = values[n];
    if (place !== undefined && place.textContent !== value) place.textContent = value;
  });
}
