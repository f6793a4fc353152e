// The distance between neighbouring motions and the numerical error against time, on a logarithmic axis.

import { Plot, type Range } from "../../../parts/plot.ts";

/** Maximum number of points; longer curves are thinned. */
const MOST = 4000;
/** Lower end of the axis, below the resolution of an angle in double precision. */
const LEAST = 1e-17;

export class Growth {
  readonly plot: Plot;
  readonly #labels: { readonly time: string; readonly distance: string };
  #times: number[] = [];
  #spreads: number[] = [];
  #errors: number[] = [];
  #until = 1;
  #range: Range = [-1, 0];
  #words = "";

  constructor(title: string, labels: { readonly time: string; readonly distance: string }, legend: Node) {
    this.plot = new Plot(title, legend);
    this.#labels = labels;
  }

  begin(): void {
    [this.#times, this.#spreads, this.#errors, this.#until, this.#range] = [[], [], [], 1, [-1, 0]];
  }

  describe(words: string): void {
    this.#words = words;
    this.plot.canvas.setAttribute("aria-label", words);
  }

  add(time: number, spread: number, error: number): void {
    for (const [list, value] of [[this.#times, time], [this.#spreads, logarithm(spread)], [this.#errors, logarithm(error)]] as const) list.push(value);
    if (this.#times.length > MOST) for (const list of [this.#times, this.#spreads, this.#errors]) thin(list);
    this.#show(time);
  }

  #show(time: number): void {
    const finite = [...this.#spreads.slice(-1), ...this.#errors.slice(-1)].filter(Number.isFinite);
    const [low, high] = [Math.floor(Math.min(this.#range[0], ...finite)), Math.ceil(Math.max(this.#range[1], ...finite))];
    const until = time > this.#until ? 1.5 * time : this.#until;
    if (this.#times.length === 1 || until !== this.#until || low !== this.#range[0] || high !== this.#range[1]) {
      [this.#until, this.#range] = [until, [low, high]];
      const every = Math.ceil((high - low) / 6);
      const yTicks = Array.from({ length: Math.floor((high - low) / every) + 1 }, (_, n): [number, string] => [low + n * every, `1e${low + n * every}`.replace("-", "−")]);
      this.plot.show({ x: [0, until], y: this.#range, xLabel: this.#labels.time, yLabel: this.#labels.distance, yTicks }, this.#words, () => {});
    }
    this.plot.move((pen) => {
      pen.line(this.#times, this.#spreads, "curve-1", 2);
      pen.line(this.#times, this.#errors, "curve-2", 2, [5, 3]);
    });
  }
}

function logarithm(value: number): number {
  return value > LEAST ? Math.log10(value) : NaN;
}

/** Every other value. */
function thin(list: number[]): void {
  let to = 0;
  for (let at = 0; at < list.length; at += 2) list[to++] = list[at] ?? NaN;
  list.length = to;
}
