// Kinetic, potential and total energy as bars, and what friction has made of it: parts of the energy at rest upright, or joules where the mass is known.

import { element } from "../../parts/element.ts";
import { digits } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";

const words = text.pendulum.graphs.energy;
const KINDS = ["kinetic", "potential", "total", "heat"] as const;

export class Bars {
  readonly element: HTMLElement;
  readonly #bars: readonly { readonly fill: HTMLElement; readonly value: HTMLElement; readonly column: HTMLElement }[];

  constructor() {
    this.#bars = KINDS.map((kind) => {
      const [fill, value] = [element("i", { class: kind }), element("b")];
      return { fill, value, column: element("div", { class: "bar" }, value, element("div", { class: "track" }, fill), element("span", {}, words[kind])) };
    });
    this.element = element("div", { class: "bars", role: "group", "aria-label": words.bars });
  }

  /** Shows energies over 2mgl, with heat if there is friction; `joules` is 2mgl, and `full` the energy of a full bar over 2mgl. */
  show(kinetic: number, potential: number, heat: number | undefined, full: number, joules: number | undefined): void {
    const energies = [kinetic, potential, kinetic + potential, heat].filter((energy) => energy !== undefined);
    if (this.element.childElementCount !== energies.length) this.element.replaceChildren(...this.#bars.slice(0, energies.length).map(({ column }) => column));
    energies.forEach((energy, n) => {
      const bar = this.#bars[n];
      if (bar === undefined) return;
      bar.column.style.setProperty("--part", Math.min(1, energy / full).toFixed(3));
      const value = joules === undefined ? energy.toFixed(2) : inJoules(energy * joules, (kinetic + potential) * joules);
      if (bar.value.textContent !== value) bar.value.textContent = value;
    });
  }
}

/** An energy with the decimals that give the total three digits, so that the numbers do not jump. */
function inJoules(energy: number, total: number): string {
  const decimals = 2 - Math.floor(Math.log10(total));
  return `${decimals >= 0 && decimals <= 6 ? energy.toFixed(decimals) : digits(energy, 3)} J`;
}
