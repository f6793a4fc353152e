// Entries without a unit have the unit shown in their field.

/** A decimal without a unit. Multiples of π do not match: they are radians. */
const NUMBER = /^\s*[+\u2212-]?(?:\d+\.?\d*|\.\d+)(?:e[+\u2212-]?\d+)?\s*$/i;

/** `true` if no number of the entry has a unit; lists and ranges have several numbers. */
export function isBare(entry: string): boolean {
  return entry.split(/[:,]/).every((number) => NUMBER.test(number));
}

/** The entry with the unit added to each number, if none has one. */
export function withUnit(entry: string, unit: string): string {
  return unit !== "" && isBare(entry) ? entry.replace(/[^:,]+/g, (number) => `${number.trim()}${unit}`) : entry;
}

/** The entry without the unit of its field, if it is a number in this unit. */
export function withoutUnit(entry: string, unit: string): string {
  const number = unit !== "" && entry.endsWith(unit) ? entry.slice(0, -unit.length) : entry;
  return NUMBER.test(number) ? number : entry;
}

/** A decimal angle in another unit, to all digits; other entries are kept. */
export function converted(entry: string, unit: string): string {
  const number = entry.replace(/(deg|rad)$/, "");
  if (number === entry || entry.endsWith(unit) || !NUMBER.test(number)) return entry;
  const value = Number(number.replace("\u2212", "-"));
  return unit === "rad" ? `${(value * Math.PI) / 180}rad` : `${Number(((value * 180) / Math.PI).toPrecision(15))}deg`;
}

/** The unit as readers write it. */
export function unitName(unit: string): string {
  return unit === "deg" ? "°" : unit.replace("^2", "²");
}

/** `true` if the variable of the equation is an angle, by its name. */
export function isOfAngle(equation: string): boolean {
  return /theta|phi|angle|[θφϑϕ]/.test(equation);
}
