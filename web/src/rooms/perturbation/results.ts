// The results of an expansion, as tables and sentences.

import { element } from "../../parts/element.ts";
import { angle, digits } from "../../parts/numbers.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Backbone, Evaluation } from "./answers.ts";

const words = text.perturbation;

/** The series term by term compared with the exact value, in sentences and as a table. */
export function evaluation(found: Evaluation): Node[] {
  const sentences = [
    found.exact === null ? "" : words.exact(digits(found.exact, 15), digits(found.exact_uncertainty, 2), found.exact_by ?? "–"),
    found.radius === null ? words.noRadius : words.radius(digits(found.radius, 6), found.radius_is ?? "–"),
    found.smallest_term_power === null ? words.still : words.smallest(found.smallest_term_power),
  ];
  const { power, coefficient, term, sum, error, bound } = words.termColumns;
  const columns = [power, coefficient, term, sum, error, bound].map((title) => ({ title, isNumber: true }));
  const rows = found.steps.map((step) => [
    String(step.power),
    shortened(step.coefficient),
    digits(step.term, 5),
    digits(step.sum, 15),
    digits(step.error, 3),
    step.bound === null ? "–" : `${digits(step.bound, 3)} (${step.bound_is})`,
  ]);
  return [...sentences.filter((it) => it !== "").map((it) => element("p", {}, it)), table(words.terms, columns, rows)];
}

/** The frequency at each amplitude: from the numerical orbit, exactly where that is known, and from the series. */
export function backbone({ points }: Backbone, isAngle: boolean, unit: string): HTMLElement {
  const { amplitude, orbit, uncertainty, exact, series, error } = words.backboneColumns;
  const columns = [amplitude, orbit, uncertainty, exact, series, error].map((title) => ({ title, isNumber: true }));
  const rows = points.map((point) => {
    const best = point.exact ?? point.angular_frequency_rad_per_s;
    return [
      isAngle ? angle(point.amplitude, unit) : digits(point.amplitude),
      digits(point.angular_frequency_rad_per_s, 13),
      digits(point.angular_frequency_uncertainty_rad_per_s, 2),
      digits(point.exact, 13),
      digits(point.series_angular_frequency_rad_per_s, 13),
      best === null || best === undefined || point.series_angular_frequency_rad_per_s === null ? "–" : digits(point.series_angular_frequency_rad_per_s - best, 3),
    ];
  });
  return table(words.backbone, columns, rows);
}

// Fractions of a hundred digits are abbreviated.
function shortened(coefficient: string): string {
  return coefficient.length <= 40 ? coefficient : `${coefficient.slice(0, 38)}…`;
}

const isFrequency = (line: Node): boolean => line.textContent?.startsWith("Ωω0=") === true;

/** Whether the lines are those of series, and not of a slow flow or of a scaling law. */
export function areSeries(lines: readonly Node[]): boolean {
  return lines.some(isFrequency);
}

/** The lines of an expansion, with a title for each variable: each of its groups begins with the frequency. */
export function grouped(lines: readonly Node[]): Node[] {
  const titles = [...words.groups];
  const isGrouped = lines.filter(isFrequency).length > 1;
  return lines.flatMap((line) => (isGrouped && isFrequency(line) ? [element("h3", {}, titles.shift() ?? ""), line] : [line]));
}
