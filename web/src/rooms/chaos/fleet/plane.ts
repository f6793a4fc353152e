// The states of an ensemble as points in a plane: the current ones, or those at each period of the drive.

import type { EnsembleFacts } from "../../../engine/ensemble.ts";
import type { Pen, Range } from "../../../parts/plot.ts";
import { Plot } from "../../../parts/plot.ts";
import { shades } from "./stage.ts";

/** State components that are drawn against each other; coordinates that are angles are reduced to one turn. */
export interface Axes {
  readonly numbers: readonly [number, number];
  readonly folded: readonly [boolean, boolean];
  readonly labels: readonly [string, string];
}

/** One coordinate and its velocity, or the first and the last coordinate. */
export function axes({ coordinates, names, units }: EnsembleFacts): Axes {
  const numbers = [0, coordinates === 1 ? names.length - 1 : coordinates - 1] as const;
  const isAngle = (number: number) => number < coordinates && units[number] === "rad";
  const label = (number: number) => [symbol(names[number] ?? ""), units[number] ?? ""].filter((it) => it !== "").join(" in ");
  return { numbers, folded: [isAngle(numbers[0]), isAngle(numbers[1])], labels: [label(numbers[0]), label(numbers[1])] };
}

/** The name of a component as it is written in formulas. */
function symbol(name: string): string {
  return name.replace("theta", "θ").replace("phi", "φ").replace("'", "′");
}

const TURN = 2 * Math.PI;
const WHOLE_TURN: Range = [-Math.PI, Math.PI];
const TICKS: readonly (readonly [number, string])[] = [[-Math.PI, "−π"], [-Math.PI / 2, "−π/2"], [0, "0"], [Math.PI / 2, "π/2"], [Math.PI, "π"]];
/** The margin of a new range, relative to the range of the values. */
const ROOM = 0.15;

export class Plane {
  readonly plot: Plot;
  #axes: Axes | undefined;
  #width = 1;
  #ranges: [Range, Range] = [[0, 0], [0, 0]];
  #words = "";
  #shades: string[] = [];
  /** Points that stay, as alternating x and y. */
  #kept: Float64Array[] = [];

  constructor(title: string) {
    this.plot = new Plot(title);
  }

  begin(axes: Axes, width: number): void {
    [this.#axes, this.#width, this.#kept, this.#shades] = [axes, width, [], shades()];
    this.#ranges = [0, 1].map((n): Range => (axes.folded[n] === true ? WHOLE_TURN : [0, 0])) as [Range, Range];
    this.plot.move(() => {});
    if (this.#ranges.every(([from, to]) => to > from)) this.#redraw();
  }

  describe(words: string): void {
    this.#words = words;
    this.plot.canvas.setAttribute("aria-label", words);
  }

  /** Shows the current states. */
  show(states: Float64Array): void {
    const points = this.#points(states);
    this.#fit(points);
    this.plot.move((pen) => this.#dots(pen, points));
  }

  /** Adds these states permanently. */
  keep(states: Float64Array): void {
    /** Maximum number of points, in several arrays. */
    const MOST = 400_000;
    const points = this.#points(states);
    this.#kept.push(points);
    while (this.#kept.length > 1 && this.#kept.reduce((sum, part) => sum + part.length / 2, 0) > MOST) this.#kept.shift();
    if (!this.#fit(points)) this.#redraw();
  }

  #points(states: Float64Array): Float64Array {
    const { numbers: [x, y], folded } = this.#axes ?? { numbers: [0, 0], folded: [false, false] };
    const points = new Float64Array((2 * states.length) / this.#width);
    for (let at = 0, to = 0; at < states.length; at += this.#width, to += 2) {
      points[to] = inTurn(states[at + x] ?? NaN, folded[0]);
      points[to + 1] = inTurn(states[at + y] ?? NaN, folded[1]);
    }
    return points;
  }

  /** Extends the axes to points outside of them; returns `true` if that was necessary. */
  #fit(points: Float64Array): boolean {
    let changed = false;
    for (const axis of [0, 1] as const) {
      let [least, most] = this.#ranges[axis];
      const empty = least === most;
      if (empty) [least, most] = [Infinity, -Infinity];
      let [low, high] = [least, most];
      for (let at = axis; at < points.length; at += 2) {
        const value = points[at] ?? NaN;
        if (value < low) low = value;
        if (value > high) high = value;
      }
      if (!(low < least || high > most) || !Number.isFinite(high - low) || this.#axes?.folded[axis] === true) continue;
      const room = ROOM * (high - low || 1);
      this.#ranges[axis] = [low < least ? low - room : low, high > most ? high + room : high];
      changed = true;
    }
    if (changed) this.#redraw();
    return changed;
  }

  #redraw(): void {
    const axes = this.#axes;
    if (axes === undefined) return;
    const [x, y] = this.#ranges;
    const [xTicks, yTicks] = axes.folded.map((folded) => (folded ? TICKS : undefined));
    const ticks = { ...(xTicks && { xTicks }), ...(yTicks && { yTicks }) };
    this.plot.show({ x, y, xLabel: axes.labels[0], yLabel: axes.labels[1], ...ticks }, this.#words, (pen) => {
      const { context } = pen;
      context.fillStyle = pen.colours["curve-1"];
      context.globalAlpha = 0.5;
      for (const points of this.#kept) {
        for (let at = 0; at < points.length; at += 2) context.fillRect(pen.x(points[at] ?? NaN) - 0.5, pen.y(points[at + 1] ?? NaN) - 0.5, 1, 1);
      }
      context.globalAlpha = 1;
    });
  }

  #dots(pen: Pen, points: Float64Array): void {
    const { context } = pen;
    const count = points.length / 2;
    for (const [shade, colour] of this.#shades.entries()) {
      const [from, to] = [shade, shade + 1].map((n) => 2 * Math.round((n * count) / this.#shades.length)) as [number, number];
      context.fillStyle = colour;
      for (let at = from; at < to; at += 2) context.fillRect(pen.x(points[at] ?? NaN) - 1, pen.y(points[at + 1] ?? NaN) - 1, 2, 2);
    }
  }
}

function inTurn(value: number, folded: boolean | undefined): number {
  return folded === true ? value - TURN * Math.round(value / TURN) : value;
}
