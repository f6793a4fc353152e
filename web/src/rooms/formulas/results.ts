// The results for the chosen formulas, as tables and cards.

import { element } from "../../parts/element.ts";
import { fromLatex } from "../../parts/latex.ts";
import { angle, digits } from "../../parts/numbers.ts";
import { scrolling } from "../../parts/scrolling.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Crossovers, Formula, Periods } from "./catalogue.ts";

const words = text.formulas;

/** The amplitude up to which a formula is within the tolerance. */
export function limit({ holds_to_rad: limit }: Formula, unit: string): string {
  if (limit === undefined) return "–";
  if (limit === null) return words.everywhere;
  return limit === 0 ? words.never : angle(limit, unit);
}

/** The values of the chosen formulas at the amplitude, the best first. */
export function values(period: Periods["results"][number], formulas: ReadonlyMap<string, Formula>, tolerance: number, unit: string): HTMLElement {
  const { formula, ratio, error, enough, limit: holds, effort, year } = words.columns;
  const columns = [
    { title: formula },
    ...[ratio, error, enough, holds, effort, year].map((title) => ({ title, isNumber: title !== enough })),
  ];
  const rows = period.formulas.map((value) => {
    const entry = formulas.get(value.key);
    const within = value.fractional_error !== null && Math.abs(value.fractional_error) <= tolerance;
    const verdict = element("span", { class: within ? "good" : "bad" }, within ? words.enough : words.notEnough);
    return [
      entry?.name ?? value.key,
      digits(value.ratio, 10),
      digits(value.fractional_error, 3),
      verdict,
      entry === undefined ? "–" : limit(entry, unit),
      String(entry?.complexity ?? "–"),
      String(entry?.year ?? "–"),
    ];
  });
  return table(words.values(angle(period.amplitude_rad, unit)), columns, rows);
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
export function card({ name, authors, year, source, latex, domain }: Formula): HTMLElement {
  const by = [authors, year === null ? "" : String(year)].filter((part) => part !== "").join(", ");
  const formula = element("div", { class: "scroll" }, fromLatex(`\\frac{T}{T_0}=${latex}`));
  scrolling(formula);
  return element(
    "article",
    { class: "formula-card" },
    element("h3", {}, by === "" ? name : `${name} (${by})`),
    formula,
    element("p", {}, words.domain(domain)),
    element("p", { class: "quiet" }, words.source(source)),
  );
}
