// A value along the horizontal axis of a picture: moved by the mouse, a finger or the keys, and shown as a line.

import { element } from "./element.ts";
import type { Frame } from "./picture.ts";

/** A picture with a horizontal axis; its first element becomes the slider. */
export interface Surface {
  readonly element: HTMLElement;
  /** The frame of the axes, in the units of the picture. */
  frame(): Frame | undefined;
  /** The position of the pointer, in the same units. */
  at(event: MouseEvent): { x: number; y: number } | undefined;
}

/** The values at both ends of the axis. */
export interface Axis {
  readonly from: number;
  readonly to: number;
}

interface Handlers {
  /** Called when the reader has moved the value. */
  readonly moved: (value: number) => void;
  /** Called with the value under the pointer, or `undefined`. */
  readonly under?: (value: number | undefined) => void;
  /** The nearest value that can be chosen. */
  readonly nearest: (value: number) => number;
  /** The steps of an arrow key, alone and with Shift, and of Page Up. */
  readonly steps: () => { usual: number; fine: number; coarse: number };
}

export class PictureSlider {
  axis: Axis = { from: 0, to: 1 };
  readonly #picture: Surface;
  readonly #slider: HTMLElement;
  readonly #handlers: Handlers;
  readonly #label: string;
  #value: number | undefined;
  /** The value before the pointer that holds the slider came down. */
  #before: number | undefined;

  constructor(picture: Surface, label: string, handlers: Handlers) {
    [this.#picture, this.#label, this.#handlers] = [picture, label, handlers];
    this.#slider = element("div", { class: "picture-slider", role: "slider", tabindex: "0", "aria-label": label, "aria-valuenow": "0" });
    this.#slider.append(picture.element.firstElementChild ?? "");
    picture.element.prepend(this.#slider);
    this.#listen();
  }

  /** Sets the value, or none, with its description in words and, optionally, a new label. */
  put(value: number | undefined, words: string, label = this.#label): void {
    this.#value = value;
    const { from, to } = this.axis;
    const said = { role: "slider", tabindex: 0, "aria-label": label, "aria-valuemin": from, "aria-valuemax": to, "aria-valuenow": value ?? from, "aria-valuetext": words };
    for (const [name, it] of Object.entries(said)) this.#slider.setAttribute(name, String(it));
  }

  /** Resets the slider without a picture. */
  rest(): void {
    for (const name of this.#slider.getAttributeNames()) if (name !== "class") this.#slider.removeAttribute(name);
  }

  /** The path of the line at the value, where it is within the axes. */
  line(): [name: string, path: string][] {
    const frame = this.#picture.frame();
    if (frame === undefined || this.#value === undefined) return [];
    const x = frame.left + ((this.#value - this.axis.from) / (this.axis.to - this.axis.from)) * (frame.right - frame.left);
    return x >= frame.left && x <= frame.right ? [["value", `M${x} ${frame.top}V${frame.bottom}`]] : [];
  }

  #listen(): void {
    const [slider, { moved, under }] = [this.#slider, this.#handlers];
    slider.addEventListener("pointerdown", (event) => {
      const value = this.#valueAt(event);
      if (value === undefined) return;
      slider.setPointerCapture(event.pointerId);
      this.#before = this.#value;
      moved(value);
    });
    // A finger that scrolls the page moves nothing.
    slider.addEventListener("pointercancel", () => {
      if (this.#before !== undefined) moved(this.#before);
      this.#before = undefined;
      under?.(undefined);
    });
    slider.addEventListener("pointerup", () => (this.#before = undefined));
    slider.addEventListener("pointermove", (event) => {
      const value = this.#valueAt(event);
      under?.(value);
      if (value !== undefined && slider.hasPointerCapture(event.pointerId)) moved(value);
    });
    slider.addEventListener("pointerleave", () => under?.(undefined));
    slider.addEventListener("keydown", (event) => this.#press(event));
  }

  #press(event: KeyboardEvent): void {
    const { usual, fine, coarse } = this.#handlers.steps();
    const step = event.shiftKey ? fine : usual;
    const steps: Readonly<Record<string, number>> = {
      ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step, PageUp: coarse, PageDown: -coarse, Home: -Infinity, End: Infinity,
    };
    const by = steps[event.key];
    if (by === undefined || this.#value === undefined) return;
    event.preventDefault();
    this.#handlers.moved(this.#within(this.#value + by));
  }

  #valueAt(event: MouseEvent): number | undefined {
    const [place, frame] = [this.#picture.at(event), this.#picture.frame()];
    if (place === undefined || frame === undefined) return undefined;
    const part = (place.x - frame.left) / (frame.right - frame.left);
    if (part < 0 || part > 1 || place.y < frame.top || place.y > frame.bottom) return undefined;
    return this.#within(this.axis.from + part * (this.axis.to - this.axis.from));
  }

  #within(value: number): number {
    return this.#handlers.nearest(Math.min(Math.max(value, this.axis.from), this.axis.to));
  }
}
