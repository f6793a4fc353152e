// Melnikov's thresholds in words: the onset of chaos near the upright position, and the overlap of resonances.

import { element } from "../../parts/element.ts";
import { angle, digits } from "../../parts/numbers.ts";
import { table } from "../../parts/table.ts";
import { text } from "../../texts/en.ts";
import type { Asking } from "./asked.ts";

const words = text.chaos.melnikov;
/** The overlap of two neighbouring resonances above which motions between them are observed to be chaotic, as in the command. */
const OVERLAP = 2 / 3;

interface Threshold {
  readonly direction: number;
  readonly value: number;
  readonly error: number;
  readonly above: boolean;
  readonly tangency: number | null;
  readonly tangency_error: number | null;
  readonly no_tangency: string | null;
}

interface Resonance {
  readonly motion_periods: number;
  readonly drive_periods: number;
  readonly direction: number;
  readonly angular_frequency_rad_per_s: number;
  readonly amplitude_rad: number | null;
  readonly angular_frequency_half_width_rad_per_s: number;
  readonly overlap: number | null;
}

/** The result of `libration melnikov`. */
interface Melnikov {
  readonly parameter: string;
  readonly value: number;
  readonly thresholds: readonly Threshold[];
  readonly resonances: readonly Resonance[];
}

export const melnikov: Asking<Melnikov> = { title: words.title, name: "melnikov", fields: ["thresholds", "periods"], said };

function said({ parameter, value, thresholds, resonances }: Melnikov): (Node | string)[] {
  const crossings = thresholds.flatMap((threshold) => [crossing(parameter, threshold), tangency(parameter, threshold)]);
  const overlaps = resonances.map(({ overlap }) => overlap).filter((overlap) => overlap !== null);
  const most = words.overlap(overlaps.length, overlaps.filter((overlap) => overlap > OVERLAP).length);
  const below = resonances.length > 0 ? [listed(`${parameter} = ${digits(value)}`, resonances), most] : [];
  return [...(crossings.length > 0 ? crossings : [words.noThreshold]), ...below];
}

function crossing(parameter: string, { direction, value, error, above }: Threshold): string {
  return words.crossing(separatrix(direction), above, parameter, digits(value, 8), digits(error, 1));
}

function tangency(parameter: string, { tangency: value, tangency_error: error, no_tangency: reason }: Threshold): string {
  return value === null ? words.noTangency(reason ?? "") : words.tangency(parameter, digits(value, 8), digits(error, 1));
}

function separatrix(direction: number): string {
  return direction > 0 ? words.upper : words.lower;
}

function listed(at: string, resonances: readonly Resonance[]): HTMLElement {
  const columns = words.columns.map((title, place) => ({ title, isNumber: place > 1 }));
  const rows = resonances.map((it) => [
    `${it.motion_periods}:${it.drive_periods}`,
    it.direction === 0 ? words.libration : it.direction > 0 ? words.rotation : words.rotationBack,
    it.amplitude_rad === null ? "" : angle(it.amplitude_rad, "deg", 7),
    digits(it.angular_frequency_rad_per_s, 5),
    digits(it.angular_frequency_half_width_rad_per_s, 3),
    it.overlap === null ? "" : digits(it.overlap, 3),
  ]);
  return element("details", {}, element("summary", {}, words.resonances(resonances.length)), table(words.caption(at), columns, rows));
}
