// Numbers for display. Saved and queried numbers have all digits.

/** The value to `count` significant digits, with an exponent instead of many zeros. */
export function digits(value: number | null | undefined, count = 6): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const written = size < 1e-4 || size >= 1e6 ? value.toExponential(count - 1).replace("e+", "e") : size >= 10 ** count ? value.toFixed(0) : value.toPrecision(count);
  return written.replace("-", "−").replace(/e-/, "e−");
}

/** The same without trailing zeros, for values that are often round. */
export function short(value: number, count = 6): string {
  const written = digits(value, count);
  return written.includes("e") ? written : written.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

/** An angle in the unit that the reader has chosen. */
export function angle(radians: number, unit: string, count = 6): string {
  const written = short(unit === "rad" ? radians : (radians * 180) / Math.PI, count);
  return unit === "rad" ? `${written} rad` : `${written}°`;
}

/** The angle as it can be entered, without loss of digits. */
export function angleEntry(degrees: number): string {
  return `${Number(degrees.toFixed(6))}deg`;
}
