// The looks of the curves, in the order of the chosen formulas: those of the command's picture of the errors.

/** Okabe and Ito's colours, on light and on dark pages. */
const COLOURS = [
  ["#0072B2", "#3FA0E0"], ["#D55E00", "#F57C2A"], ["#009E73", "#23C495"], ["#CC79A7", "#E59AC4"], ["#000000", "#EDEDED"], ["#E69F00", "#F2B632"], ["#56B4E9", "#A5DAF8"],
] as const;
const DASHES = [[], [8, 3.5], [2.5, 2.5], [10, 3, 2.5, 3], [13, 3, 2.5, 3, 2.5, 3]] as const;

export interface Look {
  readonly light: `#${string}`;
  readonly dark: `#${string}`;
  readonly width: number;
  readonly dash: readonly number[];
}

export const EXACT: Look = { light: "#000000", dark: "#EDEDED", width: 3.5, dash: [] };
export const SMALL_ANGLE: Look = { light: "#767676", dark: "#A3A3A3", width: 2, dash: [5, 3.5] };

/** The looks of the curves of these families: a family has one colour, and its curves differ by their dashes. One of more than five goes on in other colours. */
export function looks(families: readonly string[]): readonly Look[] {
  const known = [...new Set(families)];
  const used = new Set<string>();
  return families.map((family) => {
    const first = known.indexOf(family);
    const wishes = Array.from({ length: COLOURS.length * DASHES.length }, (_, step) => [(first + Math.floor(step / DASHES.length)) % COLOURS.length, (first + step) % DASHES.length] as const);
    const [colour, dashes] = wishes.find((wish) => !used.has(String(wish))) ?? [0, 0];
    used.add(String([colour, dashes]));
    const [light, dark] = COLOURS[colour] ?? COLOURS[0];
    return { light, dark, width: 1.9, dash: DASHES[dashes] ?? [] };
  });
}

/** The colour on the page as it is now. */
export function shade({ light, dark }: Look): `#${string}` {
  return matchMedia("(prefers-color-scheme: dark)").matches ? dark : light;
}

/** A short line in this look, for a legend. */
export function sample({ light, dark, width, dash }: Look): Element {
  const svg = (name: string, attributes: Readonly<Record<string, string>>) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  };
  const stroke = `light-dark(${light}, ${dark})`;
  const made = svg("svg", { class: "sample", width: "34", height: "10", viewBox: "0 0 34 10", "aria-hidden": "true" });
  made.append(svg("path", { d: "M1 5H33", stroke, "stroke-width": String(width), "stroke-dasharray": dash.join(" ") }));
  return made;
}
