// The fits that a file allows, the most probable one first.

import type { Inspection } from "./reading.ts";
import { KINDS, type Kind } from "./fields.ts";

/** Number of rows above which angles against time are a recorded swing and not a list of amplitudes. */
const MOST_AMPLITUDES = 100;

/** The fits of the file by its columns; the first one is probable only if `isClear`. */
export interface Possible {
  readonly kinds: readonly Kind[];
  readonly isClear: boolean;
}

export function possible(found: Inspection): Possible {
  const clear = clearOnes(found);
  if (clear.length > 0) return { kinds: clear, isClear: true };
  const most = Math.max(0, ...found.sheets.map(({ columns }) => columns.filter(({ numbers }) => numbers > 1).length));
  return { kinds: most >= 2 ? KINDS : most === 1 ? ["gates"] : [], isClear: false };
}

function clearOnes({ traces, gate_times, table_fit, sheets }: Inspection): Kind[] {
  const names = sheets.flatMap(({ columns }) => columns.map(({ name }) => name.toLowerCase()));
  const has = (pattern: RegExp) => names.some((name) => pattern.test(name));
  const rows = Math.max(0, ...sheets.map(({ rows }) => rows));
  if (sheets.some(isResponse)) return ["response"];
  const isDecay = has(/turning|amplitude|umkehr|auslenkung/) && has(/^(t|n)\b|time|swing|zeit|number|schwingung/) && table_fit === undefined && rows <= MOST_AMPLITUDES;
  if (isDecay) return traces.length > 0 ? ["amplitudes", "trace"] : ["amplitudes"];
  if (traces.length > 0) return rows <= MOST_AMPLITUDES ? ["trace", "amplitudes"] : ["trace"];
  if (gate_times !== null) return ["gates"];
  if (table_fit !== undefined) return [table_fit.replace("fit ", "") as Kind];
  return twoTables(names) ? ["lengths"] : [];
}

// `true` for amplitudes against frequencies, which are not times even if they increase throughout.
function isResponse({ columns }: Inspection["sheets"][number]): boolean {
  const has = (word: string) => columns.some(({ name }) => name.toLowerCase().includes(word));
  return has("freq") && has("amplitude") && !columns.some(({ quantity }) => quantity === "time");
}

// `true` for two tables of lengths and periods next to each other, between which the fit asks to choose.
function twoTables(names: readonly string[]): boolean {
  const count = (pattern: RegExp) => names.filter((name) => pattern.test(name)).length;
  return count(/^l\b|length/) > 1 && count(/^t\b|period/) > 1;
}
