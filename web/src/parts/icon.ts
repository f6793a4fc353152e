// Pictures on buttons, drawn in the colour of the text.

const PATHS = {
  play: "M7 4l13 8-13 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  restart: "M5 4h3v16H5zM20 4v16L9 12z",
  back: "M15 5v14l-9-7zM17 5h2v14h-2z",
  forth: "M9 5v14l9-7zM5 5h2v14H5z",
  undo: "M9 4L3 9.5 9 15v-4h5a4 4 0 010 8H8v2h6a6 6 0 000-12H9z",
  redo: "M15 4l6 5.5L15 15v-4h-5a4 4 0 000 8h6v2h-6a6 6 0 010-12h5z",
  reverse: "M4 9l6-5v4h5a5 5 0 010 10H7v-2h8a3 3 0 000-6h-5v4z",
} as const;
export type Icon = keyof typeof PATHS;

/** The picture, which is hidden from screen readers: the button has a name. */
export function icon(name: Icon): SVGElement {
  const make = (kind: string, attributes: Readonly<Record<string, string>>) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", kind);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  };
  const drawn = make("svg", { viewBox: "0 0 24 24", width: "20", height: "20", fill: "currentColor", "aria-hidden": "true" });
  drawn.append(make("path", { d: PATHS[name] }));
  return drawn as SVGElement;
}
