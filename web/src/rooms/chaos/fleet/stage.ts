// The bodies of all motions of an ensemble, drawn over each other.

import { colours, onColours } from "../../../parts/colours.ts";
import { element } from "../../../parts/element.ts";

/** Number of colours; neighbouring motions have neighbouring colours. */
const SHADES = 12;

/** The colours from the first motion to the last. */
export function shades(): string[] {
  const { "curve-1": first, "curve-2": last } = colours();
  return Array.from({ length: SHADES }, (_, n) => `color-mix(in oklab, ${first}, ${last} ${(100 * n) / (SHADES - 1)}%)`);
}

export class Stage {
  readonly element: HTMLElement;
  readonly canvas = element("canvas", { class: "fleet-stage", role: "img" });
  readonly #context = this.canvas.getContext("2d");
  readonly #observer = new ResizeObserver(() => this.#fit());
  readonly #forget = onColours(() => this.#fit());
  #shades = shades();
  #reach = 1;
  #bodies: Float64Array = new Float64Array();
  #each = 0;
  #isSeen = false;
  readonly #sight = new IntersectionObserver((entries) => {
    this.#isSeen = entries.at(-1)?.isIntersecting ?? false;
    this.#draw();
  });

  constructor(title: string) {
    this.element = element("figure", { class: "plot" }, element("figcaption", {}, title), this.canvas);
    this.#observer.observe(this.canvas);
    this.#sight.observe(this.canvas);
  }

  /** Begins a new ensemble with a number of bodies for each motion. */
  begin(each: number): void {
    [this.#each, this.#reach] = [each, 0];
    this.element.hidden = each === 0;
  }

  describe(words: string): void {
    this.canvas.setAttribute("aria-label", words);
  }

  show(bodies: Float64Array): void {
    this.#bodies = bodies;
    this.#draw();
  }

  close(): void {
    this.#observer.disconnect();
    this.#sight.disconnect();
    this.#forget();
  }

  #fit(): void {
    this.#shades = shades();
    const scale = Math.min(devicePixelRatio, 2);
    const { clientWidth, clientHeight } = this.canvas;
    [this.canvas.width, this.canvas.height] = [Math.round(clientWidth * scale), Math.round(clientHeight * scale)];
    this.#context?.setTransform(scale, 0, 0, scale, 0, 0);
    this.#draw();
  }

  // Out of sight nothing is drawn.
  #draw(): void {
    if (!this.#isSeen) return;
    const context = this.#context;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (context === null || this.#each === 0 || width === 0) return;
    context.clearRect(0, 0, width, height);
    this.#reach = Math.max(this.#reach, farthest(this.#bodies));
    const unit = (0.47 * Math.min(width, height)) / (this.#reach || 1);
    const [right, up] = [(x: number) => width / 2 + unit * x, (y: number) => height / 2 - unit * y];
    const size = 4 * this.#each;
    const count = this.#bodies.length / size;
    for (const [shade, colour] of this.#shades.entries()) {
      const [from, to] = [shade, shade + 1].map((n) => Math.round((n * count) / SHADES)) as [number, number];
      context.strokeStyle = context.fillStyle = colour;
      this.#rods(context, from * size, to * size, right, up);
      this.#tips(context, from * size, to * size, size, right, up);
    }
    this.#first(context, right, up);
  }

  #rods(context: CanvasRenderingContext2D, from: number, to: number, right: (x: number) => number, up: (y: number) => number): void {
    context.globalAlpha = 0.12;
    context.lineWidth = 1;
    context.beginPath();
    for (let at = from; at < to; at += 4) {
      const [x, y] = [this.#bodies[at] ?? NaN, this.#bodies[at + 1] ?? NaN];
      const [pivotX, pivotY] = [this.#bodies[at + 2] ?? NaN, this.#bodies[at + 3] ?? NaN];
      if (!Number.isFinite(x + y + pivotX + pivotY)) continue;
      context.moveTo(right(pivotX), up(pivotY));
      context.lineTo(right(x), up(y));
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  /** The first motion, as a pendulum with bobs. */
  #first(context: CanvasRenderingContext2D, right: (x: number) => number, up: (y: number) => number): void {
    context.strokeStyle = context.fillStyle = colours().ink;
    context.lineWidth = 3;
    for (let at = 0; at < 4 * this.#each; at += 4) {
      const [x = NaN, y = NaN, pivotX = NaN, pivotY = NaN] = this.#bodies.subarray(at, at + 4);
      if (!Number.isFinite(x + y + pivotX + pivotY)) return;
      context.beginPath();
      context.moveTo(right(pivotX), up(pivotY));
      context.lineTo(right(x), up(y));
      context.stroke();
      context.beginPath();
      context.arc(right(x), up(y), 8, 0, 2 * Math.PI);
      context.fill();
    }
  }

  /** The last body of each motion. */
  #tips(context: CanvasRenderingContext2D, from: number, to: number, size: number, right: (x: number) => number, up: (y: number) => number): void {
    for (let at = from + size - 4; at < to; at += size) {
      const [x, y] = [this.#bodies[at] ?? NaN, this.#bodies[at + 1] ?? NaN];
      context.fillRect(right(x) - 1.5, up(y) - 1.5, 3, 3);
    }
  }
}

/** The distance of the farthest body. */
function farthest(bodies: Float64Array): number {
  let square = 0;
  for (let at = 0; at + 1 < bodies.length; at += 4) {
    const here = (bodies[at] ?? 0) ** 2 + (bodies[at + 1] ?? 0) ** 2;
    if (here > square) square = here;
  }
  return Math.sqrt(square);
}
