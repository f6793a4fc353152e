// The exchange of energy between modes in words: resonant terms of the slow flow, period and depth of the exchange.

import { element } from "../../parts/element.ts";
import { digits, short } from "../../parts/numbers.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Asking } from "./asked.ts";

const words = text.chaos.exchange;

interface Term {
  readonly mode: number;
  readonly monomial: string;
  readonly real: number;
  readonly imaginary: number;
  readonly exact: string | null;
  readonly kind: string;
  readonly detuning_rad_per_s: number;
}

/** The result of `libration resonance`. */
interface SlowFlow {
  readonly modes: readonly { readonly mode: number; readonly angular_frequency_rad_per_s: number }[];
  readonly slow_terms: readonly Term[];
  readonly small_divisors: readonly { readonly mode: number; readonly monomial: string; readonly divisor_rad_per_s: number }[];
  readonly exchange?: {
    readonly period_s: number;
    readonly error_s: number;
    readonly closed_form_s: number | null;
    readonly measured_period_s: number;
    readonly measured_error_s: number;
    readonly relative_difference: number;
    readonly amplitudes: readonly (readonly [number, number])[];
  };
  readonly no_exchange: string | null;
}

export const exchange: Asking<SlowFlow> = { title: words.title, name: "resonance", fields: ["order", "about"], said };

function said(flow: SlowFlow): (Node | string)[] {
  const { modes, slow_terms: terms, small_divisors: divisors, no_exchange: reason } = flow;
  const frequencies = words.modes(modes.map((mode) => short(mode.angular_frequency_rad_per_s)));
  const resonant = terms.filter(({ kind }) => kind === "resonance").map(({ monomial, mode }) => words.term(monomial, mode));
  const smallest = divisors[0] === undefined ? [] : [words.divisor(divisors[0].monomial, divisors[0].mode, short(divisors[0].divisor_rad_per_s))];
  const exchanged = flow.exchange === undefined ? (reason === null ? [] : [words.noExchange(reason)]) : exchangeSaid(flow.exchange);
  return [...exchanged, frequencies, resonant.length > 0 ? words.resonant(resonant) : words.noResonance, ...smallest, ...(terms.length > 0 ? [listed(terms)] : [])];
}

function listed(terms: readonly Term[]): HTMLElement {
  const columns = words.columns.map((title, place) => ({ title, isNumber: place === 3 }));
  const rows = terms.map((term) => [words.term(term.monomial, term.mode), coefficient(term), words.kinds[term.kind] ?? term.kind, digits(term.detuning_rad_per_s, 3)]);
  return element("details", {}, element("summary", {}, words.terms(terms.length)), table(words.caption, columns, rows));
}

function exchangeSaid(found: NonNullable<SlowFlow["exchange"]>): string[] {
  const closed = found.closed_form_s === null ? [] : [words.closed(digits(found.closed_form_s, 8))];
  const depths = found.amplitudes.map(([least, most], place) => words.depth(place + 1, digits(least, 4), digits(most, 4), digits(100 * (1 - (least / most) ** 2), 3)));
  return [
    words.measured(digits(found.measured_period_s, 10), digits(found.measured_error_s, 1)),
    words.slow(digits(found.period_s, 10), digits(found.error_s, 1), digits(found.relative_difference, 2)),
    ...closed,
    ...depths,
  ];
}

function coefficient({ exact, real, imaginary }: Term): string {
  if (exact !== null) return exact;
  return real === 0 ? `${digits(imaginary)}i` : words.complex(digits(real), digits(imaginary));
}
