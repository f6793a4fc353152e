// A plot on canvas: axes and curves are kept, moving parts are drawn over them in each frame.

import { element } from "./element.ts";
import { type Colour, type Colours, colours } from "./colours.ts";

export type Range = readonly [number, number];

export interface Axes {
  readonly x: Range;
  readonly y: Range;
  readonly xLabel: string;
  readonly yLabel: string;
  /** Ticks with their labels; by default round numbers. */
  readonly xTicks?: readonly (readonly [number, string])[];
  readonly yTicks?: readonly (readonly [number, string])[];
  /** `true` for equal units on both axes. */
  readonly square?: boolean;
}

/** Draws in the units of the axes. */
export class Pen {
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly x: (value: number) => number,
    readonly y: (value: number) => number,
    readonly colours: Colours,
    /** The size of 1 px at the usual text size. */
    readonly unit: number,
  ) {}

  /** A line in a colour of the page, or in any other. */
  line(xs: ArrayLike<number>, ys: ArrayLike<number>, colour: Colour | `#${string}`, width = 1.75, dash: number[] = []): void {
    const { context } = this;
    context.beginPath();
    let drawn = false;
    for (let n = 0; n < xs.length; n++) {
      const [x, y] = [this.x(xs[n] ?? NaN), this.y(ys[n] ?? NaN)];
      if (!Number.isFinite(y) || !Number.isFinite(x)) drawn = false;
      else if (drawn) context.lineTo(x, y);
      else {
        context.moveTo(x, y);
        drawn = true;
      }
    }
    context.setLineDash(dash);
    context.strokeStyle = colour in this.colours ? this.colours[colour as Colour] : colour;
    context.lineWidth = width;
    context.stroke();
    context.setLineDash([]);
  }

  dot(x: number, y: number, colour: Colour, radius = 5): void {
    const { context } = this;
    context.beginPath();
    context.arc(this.x(x), this.y(y), radius, 0, 2 * Math.PI);
    context.fillStyle = this.colours[colour];
    context.fill();
  }

  circle(x: number, y: number, radius: number, colour: Colour): void {
    const { context } = this;
    context.beginPath();
    context.arc(this.x(x), this.y(y), Math.abs(this.x(radius) - this.x(0)), 0, 2 * Math.PI);
    context.strokeStyle = this.colours[colour];
    context.lineWidth = 1;
    context.stroke();
  }

  /** Names of curves, along the upper edge. */
  legend(entries: readonly (readonly [Colour, string])[]): void {
    const { context, unit } = this;
    context.textAlign = "left";
    context.textBaseline = "middle";
    let x = 66 * unit;
    for (const [colour, name] of entries) {
      context.fillStyle = this.colours[colour];
      context.fillRect(x, 14 * unit, 14 * unit, 4 * unit);
      context.fillStyle = this.colours.ink;
      context.fillText(name, x + 18 * unit, 16 * unit);
      x += 28 * unit + context.measureText(name).width;
    }
  }
}

const FONT = "system-ui, 'DejaVu Sans', sans-serif";

/** Distances from the edges of the canvas, or positions of the edges of a frame. */
interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The text size of the page relative to the usual one. */
function letterUnit(): number {
  return parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
}

function margins(unit: number): Box {
  return { left: 60 * unit, right: 18 * unit, top: 8 * unit, bottom: 36 * unit };
}

export class Plot {
  readonly element: HTMLElement;
  readonly canvas = element("canvas", { role: "img" });
  readonly #still = document.createElement("canvas");
  readonly #context = this.canvas.getContext("2d");
  readonly #observer: ResizeObserver;
  readonly #sight: IntersectionObserver;
  #colours: Colours | undefined;
  #unit: number | undefined;
  #isSeen = false;
  #isStale = false;
  #frame: Frame | undefined;
  #axes: Axes | undefined;
  #curves: (pen: Pen) => void = () => {};
  #moving: (pen: Pen) => void = () => {};
  #pen: Pen | undefined;

  constructor(title: string, ...below: Node[]) {
    this.element = element("figure", { class: "plot" }, element("figcaption", {}, title), this.canvas, ...below);
    this.#observer = new ResizeObserver(() => this.redraw());
    this.#observer.observe(this.canvas);
    // Out of sight nothing is drawn.
    this.#sight = new IntersectionObserver((entries) => {
      this.#isSeen = entries.at(-1)?.isIntersecting ?? false;
      if (this.#isSeen && this.#isStale) this.redraw();
    });
    this.#sight.observe(this.canvas);
    addEventListener("beforeprint", this.#see);
  }

  /** Calls back with the values of a point that is clicked. */
  onPoint(clicked: (x: number, y: number) => void): void {
    this.canvas.addEventListener("click", (event) => {
      // The browser says only afterwards that a graph has come into sight.
      if (this.#isStale) this.#see();
      const { x, y } = this.at(event);
      if (this.#frame !== undefined) clicked(...this.#frame.at(x, y));
    });
  }

  /** The frame of the axes, in px of the canvas. */
  frame(): Box | undefined {
    return this.#frame?.box;
  }

  /** The position of the pointer, in the same px. */
  at(event: MouseEvent): { x: number; y: number } {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  /** Draws the static part, described by `words`. */
  show(axes: Axes, words: string, curves: (pen: Pen) => void): void {
    [this.#axes, this.#curves] = [axes, curves];
    if (this.canvas.getAttribute("aria-label") !== words) this.canvas.setAttribute("aria-label", words);
    this.#draw();
  }

  readonly #see = () => {
    this.#isSeen = true;
    this.redraw();
  };

  /** Draws the moving part. */
  move(moving: (pen: Pen) => void): void {
    this.#moving = moving;
    this.#picture();
  }

  /** Draws with the present colours and size of letters. */
  redraw(): void {
    [this.#colours, this.#unit] = [colours(), letterUnit()];
    this.#draw();
  }

  #draw(): void {
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    const axes = this.#axes;
    this.#isStale = !this.#isSeen;
    if (axes === undefined || width === 0 || height === 0 || this.#isStale) return;
    const scale = Math.min(devicePixelRatio, 2);
    for (const canvas of [this.canvas, this.#still]) {
      [canvas.width, canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
    }
    const context = this.#still.getContext("2d");
    if (context === null) return;
    context.scale(scale, scale);
    const unit = (this.#unit ??= letterUnit());
    const margin = margins(unit);
    const frame = (this.#frame = framed(axes, width, height, margin));
    const all = (this.#colours ??= colours());
    const pen = new Pen(context, frame.x, frame.y, all, unit);
    drawAxes(pen, frame.axes, width, height, margin);
    context.save();
    context.beginPath();
    context.rect(margin.left, 0, width - margin.left, height - margin.bottom + 4);
    context.clip();
    this.#curves(pen);
    context.restore();
    if (this.#context !== null) {
      this.#context.setTransform(scale, 0, 0, scale, 0, 0);
      this.#pen = new Pen(this.#context, frame.x, frame.y, all, unit);
    }
    this.#picture();
  }

  close(): void {
    this.#observer.disconnect();
    this.#sight.disconnect();
    removeEventListener("beforeprint", this.#see);
  }

  #picture(): void {
    const pen = this.#pen;
    if (pen === undefined || !this.#isSeen) {
      this.#isStale = true;
      return;
    }
    const { context } = pen;
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.#still, 0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    this.#moving(pen);
  }
}

interface Frame {
  readonly axes: Axes;
  readonly box: Box;
  readonly x: (value: number) => number;
  readonly y: (value: number) => number;
  /** The values at a point in px. */
  readonly at: (x: number, y: number) => [x: number, y: number];
}

function framed(axes: Axes, width: number, height: number, margin: Box): Frame {
  const [across, up] = [width - margin.left - margin.right, height - margin.top - margin.bottom];
  let { x, y } = axes;
  if (axes.square === true) {
    const unit = Math.max((x[1] - x[0]) / across, (y[1] - y[0]) / up);
    const [centreX, centreY] = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2];
    x = [centreX - (unit * across) / 2, centreX + (unit * across) / 2];
    y = [centreY - (unit * up) / 2, centreY + (unit * up) / 2];
  }
  const [x0, y0] = [x[0], y[0]];
  const [perX, perY] = [across / (x[1] - x0), up / (y[1] - y0)];
  return {
    axes: { ...axes, x, y },
    box: { left: margin.left, right: width - margin.right, top: margin.top, bottom: height - margin.bottom },
    x: (value) => margin.left + (value - x0) * perX,
    y: (value) => height - margin.bottom - (value - y0) * perY,
    at: (across, down) => [x0 + (across - margin.left) / perX, y0 + (height - margin.bottom - down) / perY],
  };
}

function drawAxes(pen: Pen, axes: Axes, width: number, height: number, margin: Box): void {
  const { context, unit } = pen;
  const [left, right, top, bottom] = [margin.left, width - margin.right, margin.top, height - margin.bottom];
  context.font = `${12 * unit}px ${FONT}`;
  context.fillStyle = pen.colours.quiet;
  context.strokeStyle = pen.colours.line;
  context.lineWidth = 1;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const [value, words] of axes.xTicks ?? ticks(axes.x, (right - left) / (60 * unit))) {
    const x = Math.round(pen.x(value)) + 0.5;
    stroke(context, x, top, x, bottom);
    context.fillText(words, x, bottom + 4 * unit);
  }
  context.fillText(axes.xLabel, (left + right) / 2, bottom + 19 * unit);
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const [value, words] of axes.yTicks ?? ticks(axes.y, (bottom - top) / (36 * unit))) {
    const y = Math.round(pen.y(value)) + 0.5;
    stroke(context, left, y, right, y);
    context.fillText(words, left - 4 * unit, y);
  }
  context.save();
  context.translate(10 * unit, (top + bottom) / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText(axes.yLabel, 0, 0);
  context.restore();
}

function stroke(context: CanvasRenderingContext2D, x1: number, y1: number, x2: number, y2: number): void {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

/** Round numbers in a range, with at most `most` intervals. */
export function ticks([from, to]: Range, most: number): [number, string][] {
  const raw = (to - from) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= raw) ?? 10);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return multiples(step, [from, to]).map((it) => {
    const words = decimals > 6 ? it.toExponential(1) : it.toFixed(decimals);
    return [it, words.replace(/^-(?=0\.?0*$)/, "").replace("-", "−")];
  });
}

/** The multiples of a step in a range. Beyond 2⁵³ steps neighbouring multiples are the same number: there are none. */
export function multiples(step: number, [from, to]: Range): number[] {
  const [first, last] = [Math.ceil(from / step - 1e-9), Math.floor(to / step + 1e-9)];
  if (!(Math.max(-first, last) < 2 ** 53)) return [];
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, n) => (first + n) * step);
}
