// A planet or a pendulum whose gravity or length is hidden until it is revealed. A number in the link chooses it.

/** What is hidden, in SI units. */
export interface Secret {
  readonly gravity?: number;
  readonly length?: number;
}

/** The hidden value of an entry such as `planet-4711`; nothing for any other entry. */
export function secretOf(entry: string): Secret {
  const [, kind, number] = /^(planet|pendulum)-(\d{1,6})$/.exec(entry) ?? [];
  if (kind === undefined || number === undefined) return {};
  const part = fraction(Number(number));
  return kind === "planet" ? { gravity: Number((1.5 + 23 * part).toFixed(2)) } : { length: Number((0.25 + 1.6 * part).toFixed(3)) };
}

/** A new entry. */
export function newSecret(kind: "planet" | "pendulum"): string {
  return `${kind}-${Math.floor(1e6 * Math.random())}`;
}

/** A number in [0, 1) that does not show its origin: a multiplicative hash. */
function fraction(number: number): number {
  return (Math.imul(number + 1, 0x9e3779b1) >>> 0) / 2 ** 32;
}
