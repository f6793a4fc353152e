// The range of a parameter, as `A=1:1.5:0.005`, and coarser ones that take less time.

export interface Range {
  readonly name: string;
  readonly from: number;
  readonly to: number;
  readonly step: number;
}

/** The range if it consists of plain numbers; errors in others are reported by the command. */
export function range(written: string): Range | undefined {
  const [, name, ends] = /^\s*([^\s=]+)\s*=\s*(\S+)\s*$/.exec(written) ?? [];
  const [from, to, step] = ends?.split(":").map(Number) ?? [];
  const isRange = name !== undefined && from !== undefined && to !== undefined && step !== undefined && to > from && step > 0;
  return isRange ? { name, from, to, step } : undefined;
}

/** Ranges with fewer values first, so that the diagram is visible early; the last one is as it was written. */
export function stages(written: string): string[] {
  const found = range(written);
  if (found === undefined) return [written];
  const { name, from, to, step } = found;
  const count = (to - from) / step;
  const coarser = [16, 4].filter((factor) => count / factor >= 8);
  return [...coarser.map((factor) => `${name}=${from}:${to}:${Number((step * factor).toPrecision(12))}`), written];
}

/** A value of the range, written with no more digits than its step has. */
export function written({ step }: Range, value: number): string {
  const digits = Math.max(0, Math.ceil(-Math.log10(step)) + 1);
  return String(Number(value.toFixed(Math.min(digits, 15))));
}
