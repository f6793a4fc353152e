// The result of a fit in one line, the further results, and the reasons, in sentences.

import { digits, short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Kind } from "./fields.ts";
import type { ReadColumn } from "./reading.ts";

const words = text.laboratory.result;
/** Smallest share of the variance that is stated. */
const LEAST_SHARE = 0.01;

type Value = number | null;

/** The result of a fit, as far as it is shown in sentences. */
export interface Fitted {
  readonly rows?: number;
  readonly read_columns?: readonly ReadColumn[];
  readonly findings?: readonly { readonly findings: readonly string[] }[];
  readonly warnings?: readonly string[];
  readonly gravity_m_per_s2?: Value;
  readonly gravity_uncertainty_m_per_s2?: Value;
  readonly gravity_expanded_uncertainty_m_per_s2?: Value;
  readonly coverage_factor?: Value;
  readonly budget_inputs?: readonly { readonly input: string; readonly share: Value }[];
  readonly t0_s?: Value;
  readonly t0_uncertainty_s?: Value;
  readonly mean_period_s?: Value;
  readonly mean_period_uncertainty_s?: Value;
  readonly small_angle_period_s?: Value;
  readonly small_angle_period_uncertainty_s?: Value;
  readonly laws?: readonly { readonly key?: string; readonly t0_s?: number; readonly t0_uncertainty_s?: Value }[];
  readonly beta?: Value;
  readonly beta_uncertainty?: Value;
  readonly law?: string;
  readonly model?: string;
  readonly preferred?: string;
  readonly models?: readonly { readonly model: string; readonly quality: Value; readonly quality_uncertainty: Value }[];
  readonly quality?: Value;
  readonly quality_uncertainty?: Value;
  readonly parameters?: readonly { readonly name: string; readonly value: number; readonly uncertainty: Value; readonly unit: string }[];
  readonly coefficients?: readonly { readonly damping: string; readonly coefficient: number; readonly coefficient_uncertainty: Value; readonly unit: string }[];
  readonly decay_time_s?: Value;
  readonly decay_time_uncertainty_s?: Value;
  readonly decay_swings?: Value;
  readonly offset_m?: Value;
  readonly offset_uncertainty_m?: Value;
  readonly exponent?: Value;
  readonly exponent_uncertainty?: Value;
  readonly groups?: readonly { readonly group: string; readonly gravity_m_per_s2: number; readonly gravity_uncertainty_m_per_s2: number; readonly stands_out: boolean }[];
}

/** The most important result first, then the others of the fit. */
export function results(kind: Kind, it: Fitted): string[] {
  const exact = it.laws?.find(({ key }) => key === "exact");
  const t0 = measured(it.t0_s ?? it.small_angle_period_s ?? exact?.t0_s, it.t0_uncertainty_s ?? it.small_angle_period_uncertainty_s ?? exact?.t0_uncertainty_s, "s");
  const mean = measured(it.mean_period_s, it.mean_period_uncertainty_s, "s");
  const response = it.models?.find(({ model }) => model === it.preferred);
  const quality = measured(it.quality ?? response?.quality, it.quality_uncertainty ?? response?.quality_uncertainty);
  const gravity = measured(it.gravity_m_per_s2, it.gravity_uncertainty_m_per_s2, "m/s²");
  const all: (string | undefined)[] = [
    gravity && words.gravity(gravity),
    t0 && words.period(t0),
    mean && words.meanPeriod(mean),
    ...damping(it),
    quality && words.quality(quality),
  ];
  const decay = kind === "amplitudes" && quality !== undefined ? [words.quality(quality), ...all.filter((one) => one !== words.quality(quality))] : all;
  return decay.filter((one) => one !== undefined);
}

function damping({ parameters, coefficients, model, law, preferred }: Fitted): (string | undefined)[] {
  const found = coefficients?.map(({ damping: name, coefficient: value, coefficient_uncertainty: uncertainty, unit }) => ({ name, value, uncertainty, unit })) ?? parameters ?? [];
  const named = found.flatMap(({ name, value, uncertainty, unit }) => {
    const [label, written] = [words.names[name], measured(value, uncertainty, unit)];
    return label === undefined || written === undefined ? [] : [words.named(label, written)];
  });
  const kindOf = preferred ?? model ?? (coefficients === undefined ? undefined : law);
  return [...named, kindOf === undefined ? undefined : preferred === undefined ? words.dampingIs(words.model(kindOf)) : words.oscillatorIs(words.model(kindOf))];
}

/** Why the result can be trusted, and how far. */
export function reasons(kind: Kind, it: Fitted): string[] {
  const expanded = it.gravity_expanded_uncertainty_m_per_s2;
  const shares = (it.budget_inputs ?? []).filter(({ share }) => (share ?? 0) > LEAST_SHARE && it.gravity_m_per_s2 != null);
  const offset = kind === "lengths" && it.law?.startsWith("offset") ? measured(scaled(it.offset_m), scaled(it.offset_uncertainty_m), "mm") : undefined;
  const [exponent, beta] = [measured(it.exponent, it.exponent_uncertainty), measured(it.beta, it.beta_uncertainty)];
  const decay = measured(it.decay_time_s, it.decay_time_uncertainty_s, "s");
  const all: (string | undefined)[] = [
    expanded == null || it.gravity_m_per_s2 == null ? undefined : words.expanded(digits(expanded, 2), digits(it.coverage_factor, 3)),
    ...shares.map(({ input, share }) => words.share(words.input(input), `${(100 * (share ?? 0)).toFixed(0)} %`)),
    offset && words.offset(offset),
    exponent && words.exponent(exponent),
    beta && words.beta(beta),
    decay !== undefined ? words.decay(decay) : it.decay_swings == null ? undefined : words.decaySwings(digits(it.decay_swings, 3)),
    ...(it.groups ?? []).map((group) => words.group(group.group, measured(group.gravity_m_per_s2, group.gravity_uncertainty_m_per_s2, "m/s²") ?? "", group.stands_out)),
  ];
  return all.filter((one) => one !== undefined);
}

function scaled(metres: Value | undefined): Value {
  return metres == null ? null : 1000 * metres;
}

/** The value with its uncertainty to two digits, or to three digits if no uncertainty is known. */
export function measured(value: Value | undefined, uncertainty: Value | undefined, unit = ""): string | undefined {
  if (value == null || !Number.isFinite(value)) return undefined;
  const after = unit === "" ? "" : ` ${unit.replace("^2", "²")}`;
  if (uncertainty == null || !(uncertainty > 0) || !Number.isFinite(uncertainty)) return `${short(value, 3)}${after}`;
  const two = Number(uncertainty.toPrecision(2));
  const power = Math.floor(Math.log10(two));
  const size = Math.max(Math.abs(value), two);
  if (size < 1e-4 || size >= 1e6) return `(${digits(value, Math.max(1, Math.floor(Math.log10(size)) - power + 2))} ± ${digits(two, 2)})${after}`;
    const decimals = Math.max(0, 1 - power);
  return `${coarse(value, power).toFixed(decimals).replace("-", "−")} ± ${two.toFixed(decimals)}${after}`;
}

// Digits of whole numbers beyond the second of the uncertainty are zero.
function coarse(value: number, power: number): number {
  const step = 10 ** (power - 1);
  return power > 1 ? Math.round(value / step) * step : value;
}
