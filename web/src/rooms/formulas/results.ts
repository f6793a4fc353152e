// The results for the chosen formulas, as tables and cards.

import { button, element } from "../../parts/element.ts";
import { fromLatex } from "../../parts/latex.ts";
import { angle, digits } from "../../parts/numbers.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Crossovers, Formula, Periods } from "./catalogue.ts";
import { withMathematics } from "./domain.ts";
import { EXACT, type Look, looks, sample, SMALL_ANGLE } from "./looks.ts";

const words = text.formulas;

/** The amplitude up to which a formula is within the tolerance. */
export function limit({ holds_to_rad: limit }: Formula, unit: string): string {
  if (limit === undefined) return "–";
  if (limit === null) return words.everywhere;
  return limit === 0 ? words.never : angle(limit, unit);
}

/** The values at an amplitude: exact, by the small-angle approximation, and by the chosen formulas, in the order of the curves. */
export function readout(period: Periods["results"][number], chosen: readonly Formula[], tolerance: number, unit: string, opened: (key: string) => void): HTMLElement {
  const { formula, ratio, error, enough } = words.columns;
  const columns = [{ title: formula }, ...[ratio, error, enough].map((title) => ({ title, isNumber: title !== enough }))];
  const named = (its: Look, name: Node | string) => element("span", { class: "named" }, sample(its), name);
  const line = (its: Look, name: Node | string, value: number | null, itsError: number | null) => {
    const within = itsError !== null && Math.abs(itsError) <= tolerance;
    const verdict = element("span", { class: within ? "good" : "bad" }, within ? words.enough : words.notEnough);
    return [named(its, name), digits(value, 7), digits(itsError, 3), verdict];
  };
  const values = new Map(period.formulas.map((it) => [it.key, it]));
  const all = looks(chosen.map(({ family }) => family));
  const lines = chosen.map(({ key, name }, place) => {
    const value = values.get(key);
    const opener = button(name, () => opened(key), { class: "term", title: words.open });
    return line(all[place] ?? EXACT, opener, value?.ratio ?? null, value?.fractional_error ?? null);
  });
  const small = chosen.some(({ key }) => key === "small_angle") ? [] : [line(SMALL_ANGLE, words.smallAngle, 1, 1 / period.ratio - 1)];
  const rows = [[named(EXACT, words.exactName), digits(period.ratio, 7), "–", "–"], ...small, ...lines];
  return table(words.values(angle(period.amplitude_rad, unit)), columns, rows);
}

/** The curves at amplitudes about ten intervals apart, as a table: one column for each formula. */
export function curveTable(caption: string, degrees: readonly number[], columns: readonly { name: string; values: readonly number[] }[], unit: string): HTMLElement {
  const titles = [{ title: words.crossing.amplitude, isNumber: true }, ...columns.map(({ name }) => ({ title: name, isNumber: true }))];
  const shown = degrees.flatMap((degree, place) => (place % 10 === 0 || place === degrees.length - 1 ? [[degree, place] as const] : []));
  const rows = shown.map(([degree, place]) => [angle((degree * Math.PI) / 180, unit), ...columns.map(({ values }) => digits(values[place], 4))]);
  return table(caption, titles, rows);
}

/** The amplitude up to which each formula is within the tolerance, with its effort and its year. */
export function ranges(formulas: readonly Formula[], tolerance: string, unit: string): HTMLElement {
  const { formula, limit: holds, effort, year } = words.columns;
  const columns = [{ title: formula }, ...[holds, effort, year].map((title) => ({ title, isNumber: true }))];
  const rows = formulas.map((it) => [it.name, limit(it, unit), String(it.complexity), String(it.year ?? "–")]);
  return table(words.rangesCaption(tolerance), columns, rows);
}

/** The amplitudes at which one formula becomes better than another. */
export function crossovers({ crossovers }: Crossovers, formulas: ReadonlyMap<string, Formula>, unit: string): HTMLElement {
  if (crossovers.length === 0) return element("p", {}, words.noCrossovers);
  const { amplitude, below, above, error } = words.crossing;
  const name = (key: string) => formulas.get(key)?.name ?? key;
  const rows = crossovers.map((it) => [angle(it.amplitude_rad, unit), name(it.better_below), name(it.better_above), digits(it.error, 3)]);
  const columns = [{ title: amplitude, isNumber: true }, { title: below }, { title: above }, { title: error, isNumber: true }];
  return table(words.crossoversCaption, columns, rows);
}

/** The formula with its name, year and source. */
export function card({ key, name, authors, year, source, latex, domain, worst_error_to_90deg: worst }: Formula): HTMLElement {
  const by = [authors, year === null ? "" : String(year)].filter((part) => part !== "").join(", ");
  const formula = element("div", { class: "scroll" }, fromLatex(`\\frac{T}{T_0}=${latex}`));
  scrolling(formula);
  return element(
    "article",
    { class: "formula-card", id: `formula-${key}`, tabindex: "-1" },
    element("h3", {}, by === "" ? name : `${name} (${by})`),
    formula,
    element("p", {}, words.domain, ...withMathematics(domain), ".", worst === null ? "" : ` ${words.worst(digits(worst, 2))}`),
    element("p", { class: "quiet" }, words.source, ...withMathematics(source)),
  );
}
