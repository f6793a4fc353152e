// The colours of the style sheet, for canvases.

const NAMES = ["ground", "surface", "line", "ink", "quiet", "accent", "curve-1", "curve-2", "curve-3", "curve-4", "curve-5", "curve-6"] as const;
export type Colour = (typeof NAMES)[number];
export type Colours = Readonly<Record<Colour, string>>;

/** The current colours, light or dark. */
export function colours(): Colours {
  const probe = document.createElement("span");
  document.body.append(probe);
  const read = NAMES.map((name) => {
    probe.style.color = `var(--${name})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return Object.fromEntries(read) as Record<Colour, string>;
}

/** Calls back when the page changes between light and dark; returns a function that ends that. */
export function onColours(changed: () => void): () => void {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", changed);
  return () => dark.removeEventListener("change", changed);
}
