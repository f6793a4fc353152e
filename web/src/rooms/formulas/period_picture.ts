// The first picture of the room: the period against the amplitude, with the reader's amplitude.

import type { Mathematics } from "../../engine/mathematics.ts";
import { onColours } from "../../parts/colours.ts";
import { element } from "../../parts/element.ts";
import { type Pen, Plot } from "../../parts/plot.ts";
import { PictureSlider } from "../../parts/picture_slider.ts";
import { text } from "../../texts/en.ts";
import { amplitudes, type Curve, exactRatio, type Span } from "./curves.ts";
import { EXACT, type Look, shade, SMALL_ANGLE } from "./looks.ts";

const words = text.formulas;
/** The amplitude in degrees whose exact period is at the upper edge: from there on the curve leaves the picture. */
const TALLEST = 170;

export class PeriodPicture {
  readonly element: HTMLElement;
  readonly #plot: Plot;
  readonly #slider: PictureSlider;
  readonly #colours: () => void;
  #mathematics: Mathematics | undefined;
  #span: Span = { from: 0, to: 180 };
  #formulas: { degrees: readonly number[]; all: readonly Curve[]; looks: readonly Look[] } = { degrees: [], all: [], looks: [] };
  #amplitude: number | undefined;
  #under: number | undefined;

  /** `moved` receives the amplitude in degrees, `under` that under the pointer, or `undefined` when it leaves. */
  constructor(nearest: (amplitude: number) => number, moved: (amplitude: number) => void, under: (amplitude: number | undefined) => void) {
    this.#plot = new Plot(words.period.title);
    const stage = element("div", {}, this.#plot.canvas);
    this.#plot.element.append(stage, element("p", { class: "quiet" }, words.period.look));
    this.element = this.#plot.element;
    const surface = { element: stage, frame: () => this.#plot.frame(), at: (event: MouseEvent) => this.#plot.at(event) };
    const pointed = (amplitude: number | undefined) => {
      this.#under = amplitude;
      this.#move();
      under(amplitude);
    };
    this.#slider = new PictureSlider(surface, words.period.label, { moved, under: pointed, nearest, steps: () => ({ usual: 1, fine: 0.1, coarse: 10 }) });
    this.#colours = onColours(() => this.#plot.redraw());
  }

  /** Draws the exact curve and the small-angle line, with the formulas that are known. */
  begin(mathematics: Mathematics): void {
    this.#mathematics = mathematics;
    this.#draw();
  }

  /** Sets the amplitudes at the ends. */
  spread(span: Span): void {
    if (span.from === this.#span.from && span.to === this.#span.to) return;
    this.#span = span;
    this.#formulas = { degrees: [], all: [], looks: [] };
    this.#draw();
  }

  show(degrees: readonly number[], all: readonly Curve[], looks: readonly Look[]): void {
    this.#formulas = { degrees, all, looks };
    this.#draw();
  }

  /** Marks the amplitude, in degrees, with its description in words. */
  mark(amplitude: number, said: string): void {
    this.#amplitude = amplitude;
    this.#slider.axis = this.#span;
    this.#slider.put(amplitude, said);
    this.#move();
  }

  close(): void {
    this.#colours();
    this.#plot.close();
  }

  #draw(): void {
    const mathematics = this.#mathematics;
    if (mathematics === undefined) return;
    const { from, to } = this.#span;
    const degrees = amplitudes(this.#span);
    const exact = degrees.map((it) => exactRatio(mathematics, it));
    const top = exactRatio(mathematics, Math.min(to, Math.max(TALLEST, from + 0.9 * (to - from))));
    const axes = { x: [from, to] as const, y: this.#heights(top), xLabel: words.period.across, yLabel: "T / T₀", ...(to - from === 180 ? { xTicks: RIGHT_ANGLES } : {}) };
    this.#plot.show(axes, words.period.described(this.#formulas.all.length, from, to), (pen) => {
      stroke(pen, SMALL_ANGLE, [from, to], [1, 1]);
      stroke(pen, EXACT, degrees, exact);
      this.#formulas.all.forEach(({ ratios }, place) => stroke(pen, this.#formulas.looks[place] ?? EXACT, this.#formulas.degrees, ratios));
    });
    this.#move();
  }

  // Formulas that are far below the small-angle period leave the picture.
  #heights(top: number): readonly [number, number] {
    const rise = 1.04 * (top - 1);
    const values = this.#formulas.all.flatMap(({ ratios }) => ratios).filter(Number.isFinite);
    return [Math.max(Math.min(1, ...values), 1 - 0.4 * rise) - 0.08 * rise, 1 + rise];
  }

  #move(): void {
    this.#plot.move((pen) => {
      this.#line(pen, this.#amplitude, [], 2);
      if (this.#under !== this.#amplitude) this.#line(pen, this.#under, [3, 3], 1);
    });
  }

  // A vertical line at an amplitude, with a dot where it meets the exact curve.
  #line(pen: Pen, amplitude: number | undefined, dash: number[], width: number): void {
    const frame = this.#plot.frame();
    if (amplitude === undefined || frame === undefined || this.#mathematics === undefined) return;
    const x = pen.x(amplitude);
    if (x < frame.left || x > frame.right) return;
    const { context } = pen;
    context.beginPath();
    context.moveTo(x, frame.top);
    context.lineTo(x, frame.bottom);
    context.setLineDash(dash);
    context.strokeStyle = pen.colours.accent;
    context.lineWidth = width;
    context.stroke();
    context.setLineDash([]);
    const ratio = exactRatio(this.#mathematics, amplitude);
    if (pen.y(ratio) >= frame.top) pen.dot(amplitude, ratio, "accent", 5 * pen.unit);
  }
}

const RIGHT_ANGLES = [0, 30, 60, 90, 120, 150, 180].map((degrees) => [degrees, String(degrees)] as const);

function stroke(pen: Pen, its: Look, xs: readonly number[], ys: readonly number[]): void {
  pen.line(xs, ys, shade(its), its.width, [...its.dash]);
}
