// Files with millions of rows, of which every n-th is kept.

/** Number of rows above which thinning is offered: a fit of more takes minutes. */
export const MOST_ROWS = 2_000_000;
/** Number of rows that are kept at most. */
const ENOUGH = 100_000;

const NEWLINE = 10;

/** The number of lines of a text. */
export function lineCount(bytes: Uint8Array): number {
  let count = 0;
  for (let at = bytes.indexOf(NEWLINE); at >= 0; at = bytes.indexOf(NEWLINE, at + 1)) count += 1;
  return count;
}

/** The interval between the rows that are kept. */
export function interval(lines: number): number {
  return Math.ceil(lines / ENOUGH);
}

/** The file with its heading and every `every`-th line of numbers. */
export function thinned(bytes: Uint8Array, every: number): Uint8Array {
  const kept = new Uint8Array(bytes.length);
  let [to, from, row] = [0, 0, 0];
  while (from < bytes.length) {
    const end = bytes.indexOf(NEWLINE, from);
    const next = end < 0 ? bytes.length : end + 1;
    const isRow = row > 0 || isNumeric(bytes[from]);
    if (!isRow || row % every === 0) {
      kept.set(bytes.subarray(from, next), to);
      to += next - from;
    }
    if (isRow) row += 1;
    from = next;
  }
  return kept.slice(0, to);
}

// The first character of a number: a digit, a sign, a point or a blank.
function isNumeric(code: number | undefined): boolean {
  return code !== undefined && ((code >= 48 && code <= 57) || [9, 32, 43, 45, 46].includes(code));
}
