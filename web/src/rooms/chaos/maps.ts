// Stability over two parameters in words: where the state at rest is stable, its boundaries, and the curves of singular points with their ends and cusps.

import { element } from "../../parts/element.ts";
import { digits, short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Asking } from "./asked.ts";

const words = text.chaos.maps;

interface Place {
  readonly parameters: readonly [number, number];
  readonly error: number;
}

/** The result of `libration stability`. */
interface Chart {
  readonly parameters: readonly [string, string];
  readonly rest_stable_at: readonly { readonly value: number; readonly ranges: readonly (readonly [number, number])[] }[];
  /** Places between a stable and an unstable point of the grid without a boundary. */
  readonly unresolved: readonly (readonly [number, number])[];
  readonly curves: readonly {
    readonly kind: string;
    readonly at_rest: boolean;
    readonly stability_boundary: "whole" | "part" | "none";
    readonly closed: boolean;
    readonly points: readonly Place[];
    readonly cusps: readonly Place[];
  }[];
}

export const maps: Asking<Chart> = { title: words.title, name: "stability", fields: ["map", "rest", "lines"], said };

function said({ parameters, rest_stable_at: ends, curves, unresolved }: Chart): Node[] {
  const [first, second] = parameters;
  const rest = ends.map(({ value, ranges }) => words.rest(`${first} = ${short(value)}`, ranges.map(([from, to]) => words.range(second, short(from), short(to)))));
  const open = unresolved.slice(0, 1).map(([x, y]) => words.unresolved(`${first} = ${short(x)}, ${second} = ${short(y)}`, unresolved.length - 1));
  const sentences = [...rest, ...(curves.length > 0 ? [] : [words.noCurves]), ...open];
  const list = element("ol", {}, ...curves.map((curve) => element("li", {}, curveSaid(parameters, curve))));
  return [...sentences.map((sentence) => element("p", {}, sentence)), ...(curves.length > 0 ? [list] : [])];
}

function curveSaid([first, second]: Chart["parameters"], curve: Chart["curves"][number]): string {
  const { closed, points, cusps } = curve;
  const at = ({ parameters: [x, y], error }: Place) => words.place(`${first} = ${short(x)}`, `${second} = ${short(y)}`, digits(error, 1));
  const [begin, end] = [points[0], points.at(-1)];
  const way = closed ? words.closed : begin === undefined || end === undefined ? "" : words.way(at(begin), at(end));
  return words.curve(curveName(curve), way, cusps.map(at));
}

function curveName({ kind, at_rest, stability_boundary: part }: Chart["curves"][number]): string {
  const name = words.kinds[kind] ?? kind;
  if (at_rest) return words.atRest[part](name);
  if (part === "none") return words.drivenUnstable(name);
  return words.driven(kind === "fold" ? words.jump : name);
}
