// A ruler to the scale of the stage, moved by the mouse, a finger or the arrow keys; it begins left of the vertical, with its zero at the pivot.

import { colours } from "../../parts/colours.ts";
import { element } from "../../parts/element.ts";
import { short } from "../../parts/numbers.ts";
import { text } from "../../texts/en.ts";
import type { Frame } from "./drawing.ts";

const WIDTH = 52;
const STEPS: Readonly<Record<string, readonly [number, number]>> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Ruler {
  readonly element: HTMLElement;
  readonly #canvas = element("canvas");
  #frame: Frame | undefined;
  #length = NaN;
  /** The place of the zero relative to the pivot, in px. */
  #at: readonly [x: number, y: number] = [-WIDTH - 14, 0];

  constructor() {
    this.element = element("div", { class: "ruler", tabindex: "0", role: "group" }, this.#canvas);
    this.#listen();
  }

  /** Follows the scale of the stage. */
  fit(frame: Frame, length: number): void {
    if (length !== this.#length) [this.#length, this.#frame] = [length, undefined];
    const old = this.#frame;
    if (old !== undefined && old.radius === frame.radius && old.metres === frame.metres && old.x === frame.x && old.y === frame.y) return;
    this.#frame = frame;
    this.redraw();
  }

  redraw(): void {
    const frame = this.#frame;
    const context = this.#canvas.getContext("2d");
    if (frame === undefined || context === null) return;
    const [height, scale] = [frame.radius + 24, Math.min(devicePixelRatio, 2)];
    [this.#canvas.width, this.#canvas.height] = [WIDTH * scale, Math.round(height * scale)];
    [this.#canvas.style.width, this.#canvas.style.height] = [`${WIDTH}px`, `${height}px`];
    context.setTransform(scale, 0, 0, scale, 0, 0);
    const all = colours();
    const { fontFamily } = getComputedStyle(this.#canvas);
    [context.font, context.fillStyle, context.strokeStyle] = [`11px ${fontFamily}`, all.ink, all.ink];
    [context.textBaseline, context.textAlign] = ["middle", "right"];
    for (let mark = 0; mark <= 100; mark++) {
      const y = Math.round(12 + (frame.radius * mark) / 100) + 0.5;
      context.beginPath();
      context.moveTo(WIDTH, y);
      context.lineTo(WIDTH - (mark % 10 === 0 ? 16 : mark % 5 === 0 ? 11 : 6), y);
      context.stroke();
      if (mark % 10 === 0) context.fillText(short((frame.metres * mark) / 100, 3) + (mark === 0 ? " m" : ""), WIDTH - 19, y);
    }
    this.#place();
  }

  #move(x: number, y: number): void {
    this.#at = [x, y];
    this.#place();
  }

  #place(): void {
    if (this.#frame === undefined) return;
    const { style } = this.element;
    style.left = `${this.#frame.x + this.#at[0]}px`;
    // Read to a mark, as an eye does.
    const reading = (this.#length / this.#frame.metres - this.#at[1] / this.#frame.radius) * 100;
    const { name, reads } = text.pendulum.instruments.ruler;
    this.element.setAttribute("aria-label", `${reads(short((Math.round(reading) * this.#frame.metres) / 100, 3))} ${name}`);
    style.top = `${this.#frame.y + this.#at[1] - 12}px`;
  }

  #listen(): void {
    let grip: { readonly id: number; readonly x: number; readonly y: number; readonly from: readonly [number, number] } | undefined;
    this.element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || grip !== undefined) return;
      grip = { id: event.pointerId, x: event.clientX, y: event.clientY, from: this.#at };
      this.element.setPointerCapture(event.pointerId);
    });
    this.element.addEventListener("pointermove", (event) => {
      if (grip?.id === event.pointerId) this.#move(grip.from[0] + event.clientX - grip.x, grip.from[1] + event.clientY - grip.y);
    });
    this.element.addEventListener("pointerup", (event) => {
      if (grip?.id === event.pointerId) grip = undefined;
    });
    // The system took the pointer: the ruler lies where it was.
    const taken = (event: PointerEvent) => {
      if (grip?.id !== event.pointerId) return;
      this.#move(...grip.from);
      grip = undefined;
    };
    this.element.addEventListener("pointercancel", taken);
    this.element.addEventListener("lostpointercapture", taken);
    this.element.addEventListener("keydown", (event) => {
      const step = STEPS[event.key];
      if (step === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      const size = event.shiftKey ? 1 : 10;
      this.#move(this.#at[0] + size * step[0], this.#at[1] + size * step[1]);
    });
  }
}
