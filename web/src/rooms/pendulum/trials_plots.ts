// Measured periods against the amplitude, and their squares against the length, with the exact law and approximations.

import type { Engine } from "../../engine/engine.ts";
import { Mathematics } from "../../engine/mathematics.ts";
import { read } from "../../parts/answers.ts";
import { given } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import { short } from "../../parts/numbers.ts";
import type { Axes, Pen } from "../../parts/plot.ts";
import { lookedAt } from "./look.ts";
import { text } from "../../texts/en.ts";
import { mean, type Trial } from "./trials.ts";

const { trials: words, look } = text.pendulum;
const POINTS = 61;

/** The laws that are drawn: none of them if the exact values are hidden. */
export interface Laws {
  readonly gravity: number;
  /** The settings of the bench, where the table has none. */
  readonly length: number;
  readonly amplitude: number;
  readonly isHidden: boolean;
  readonly formula: string;
}

export class TrialsPlots {
  readonly element: HTMLElement;
  readonly #amplitudes = lookedAt(words.overAmplitude, look.overAmplitude);
  readonly #lengths = lookedAt(words.overLength, look.overLength);
  readonly #engine: Engine;
  #mathematics: Mathematics | undefined;
  #abort = new AbortController();

  constructor(engine: Engine) {
    this.#engine = engine;
    this.element = element("div", { class: "swing-graphs" }, this.#amplitudes.element, this.#lengths.element);
  }

  /** Draws the trials whose length, or whose amplitude, is that of the last one, and the laws. */
  async show(trials: readonly Trial[], laws: Laws): Promise<void> {
    this.#abort.abort();
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    const mathematics = (this.#mathematics ??= await Mathematics.load());
    if (signal.aborted) return;
    const last = trials.at(-1);
    const length = last !== undefined && last.length > 0 ? last.length : laws.length;
    const amplitude = last !== undefined && Number.isFinite(last.amplitude) ? last.amplitude : laws.amplitude;
    const period = (degrees: number, metres: number) => {
      const motion = mathematics.launch(`${degrees}deg`, 0, metres, laws.gravity);
      return "error" in motion ? [NaN, NaN] : [degrees === 0 ? motion.smallAnglePeriod : motion.period, motion.smallAnglePeriod];
    };
    const overAmplitude = trials.filter((trial) => !(trial.length > 0) || trial.length === length);
    const draw = (formula?: readonly [readonly number[], readonly number[]]) => this.#showAmplitudes(overAmplitude, length, laws, period, formula);
    draw();
    this.#showLengths(trials.filter((trial) => !Number.isFinite(trial.amplitude) || trial.amplitude === amplitude), amplitude, laws, period);
    if (laws.formula === "" || laws.isHidden) return;
    const formula = await this.#formula(laws, length, signal);
    if (!signal.aborted && formula !== undefined) draw(formula);
  }

  redraw(): void {
    for (const plot of [this.#amplitudes, this.#lengths]) plot.redraw();
  }

  close(): void {
    this.#abort.abort();
    for (const plot of [this.#amplitudes, this.#lengths]) plot.close();
  }

  async #formula({ formula, gravity }: Laws, length: number, signal: AbortSignal): Promise<[number[], number[]] | undefined> {
    const options = given({ formulas: formula, length: `${length}m`, gravity: `${gravity}m/s^2` });
    const { value } = await read<{ results: { amplitude_rad: number; formulas: { period_s: number | null }[] }[] }>(this.#engine, { question: "period", arguments: ["3deg:177deg:3deg"], options }, signal);
    return value && [value.results.map((it) => (it.amplitude_rad * 180) / Math.PI), value.results.map((it) => it.formulas[0]?.period_s ?? NaN)];
  }

  #showAmplitudes(trials: readonly Trial[], length: number, { isHidden, formula }: Laws, period: (degrees: number, metres: number) => number[], drawn?: readonly [readonly number[], readonly number[]]): void {
    const most = Math.min(179, Math.max(90, 1.1 * Math.max(0, ...finite(trials.map((it) => it.amplitude)))));
    const angles = Array.from({ length: POINTS }, (_, n) => (most * n) / (POINTS - 1));
    const [exact, small] = [0, 1].map((which) => angles.map((angle) => (isHidden ? NaN : (period(angle, length)[which] ?? NaN)))) as [number[], number[]];
    const points = trials.flatMap(({ amplitude, periods }) => periods.map((it): [number, number] => [amplitude, it]));
    const axes = { x: [0, most] as const, y: range([...exact, ...small, ...points.map(([, y]) => y)]), xLabel: words.amplitudeAxis, yLabel: words.periodAxis(short(length, 4)) };
    this.#amplitudes.show(axes, words.plotted(points.length), (pen) => {
      if (drawn !== undefined) pen.line(drawn[0], drawn[1], "curve-4", 1.5, [8, 4]);
      curves(pen, axes, [angles, small], [angles, exact], points);
      if (!isHidden) pen.legend([["curve-1", words.exact], ["curve-2", words.small], ...(drawn === undefined ? [] : [["curve-4", formula] as const])]);
    });
  }

  #showLengths(trials: readonly Trial[], amplitude: number, { isHidden }: Laws, period: (degrees: number, metres: number) => number[]): void {
    const most = 1.1 * Math.max(1, ...finite(trials.map((it) => it.length)));
    const ends = [most * 1e-9, most];
    const [exact, small] = [0, 1].map((which) => ends.map((metres) => (isHidden ? NaN : (period(amplitude, metres)[which] ?? NaN) ** 2))) as [number[], number[]];
    const points = trials.flatMap(({ length, periods }) => periods.map((it): [number, number] => [length, it * it]));
    const axes = { x: [0, most] as const, y: range([0, ...exact, ...small, ...points.map(([, y]) => y)]), xLabel: words.lengthAxis, yLabel: words.squareAxis(short(amplitude, 4)) };
    this.#lengths.show(axes, words.plotted(points.length), (pen) => {
      curves(pen, axes, [ends, small], [ends, exact], points);
      if (!isHidden) pen.legend([["curve-1", words.exact], ["curve-2", words.small]]);
    });
  }
}

type Curve = readonly [readonly number[], readonly number[]];

function curves(pen: Pen, _: Axes, small: Curve, exact: Curve, points: readonly (readonly [number, number])[]): void {
  pen.line(...small, "curve-2", 1.5, [5, 3]);
  pen.line(...exact, "curve-1", 2);
  for (const [x, y] of points) if (Number.isFinite(x + y)) pen.dot(x, y, "ink", 4);
}

function finite(values: readonly number[]): number[] {
  return values.filter(Number.isFinite);
}

function range(values: readonly number[]): readonly [number, number] {
  const all = finite(values);
  if (all.length === 0) return [0, 1];
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const room = 0.08 * (high - low) || 0.1 * high;
  return [low - (low === 0 ? 0 : room), high + 2 * room];
}

export function meanPeriod({ periods }: Trial): number {
  return mean(periods);
}
