// The errors of the formulas against the amplitude, with the reader's amplitude and tolerance in it.

import type { Engine } from "../../engine/engine.ts";
import { type Command, given } from "../../parts/command.ts";
import { element } from "../../parts/element.ts";
import { Picture } from "../../parts/picture.ts";
import { text } from "../../texts/en.ts";

/** The axes, amplitudes in degrees. */
export interface Axes {
  readonly from: number;
  readonly to: number;
  readonly lowest: number;
  readonly highest: number;
}

export class ErrorPicture {
  readonly element: HTMLElement;
  readonly picture: Picture;
  readonly #slider = element("div", { class: "picture-slider", role: "slider", tabindex: "0", "aria-label": text.formulas.pictureLabel });
  #axes: Axes = { from: 0, to: 180, lowest: 1e-8, highest: 10 };
  #amplitude = 60;
  #tolerance = 1e-3;

  /** `moved` gets the amplitude in degrees, `under` that under the pointer, or nothing when it leaves. */
  constructor(engine: Engine, moved: (amplitude: number) => void, under: (amplitude: number | undefined) => void) {
    this.picture = new Picture(engine, "errors", "output");
    this.#slider.append(this.picture.element.firstElementChild ?? "");
    this.picture.element.prepend(this.#slider);
    this.element = this.picture.element;
    this.#listen(moved, under);
  }

  command(keys: readonly string[], axes: Axes): Command {
    const unlessUsual = (value: number, usual: number, unit = "") => (value === usual ? undefined : `${value}${unit}`);
    this.#axes = axes;
    const options = given({
      formulas: keys.join(","),
      from: unlessUsual(axes.from, 0, "deg"),
      to: unlessUsual(axes.to, 180, "deg"),
      lowest: axes.lowest === 1e-8 ? undefined : axes.lowest.toExponential(0),
    });
    return { question: "figure errors", options };
  }

  /** Where the amplitude and the tolerance are, and the amplitude in words. */
  mark(amplitude: number, tolerance: number, words: string): void {
    [this.#amplitude, this.#tolerance] = [amplitude, tolerance];
    const [low, high] = [String(this.#axes.from), String(this.#axes.to)];
    for (const [name, value] of Object.entries({ valuemin: low, valuemax: high, valuenow: String(amplitude), valuetext: words })) {
      this.#slider.setAttribute(`aria-${name}`, value);
    }
    this.lines();
  }

  /** Draws the lines anew, as after the picture has changed. */
  lines(): void {
    const frame = this.picture.frame();
    if (frame === undefined) return;
    const { from, to, lowest, highest } = this.#axes;
    const x = frame.left + ((this.#amplitude - from) / (to - from)) * (frame.right - frame.left);
    const y = frame.bottom - (Math.log(this.#tolerance / lowest) / Math.log(highest / lowest)) * (frame.bottom - frame.top);
    const paths: [string, string][] = [];
    if (x >= frame.left && x <= frame.right) paths.push(["amplitude", `M${x} ${frame.top}V${frame.bottom}`]);
    if (y >= frame.top && y <= frame.bottom) paths.push(["limit", `M${frame.left} ${y}H${frame.right}`]);
    this.picture.overlay(paths);
  }

  #listen(moved: (amplitude: number) => void, under: (amplitude: number | undefined) => void): void {
    const slider = this.#slider;
    slider.addEventListener("pointerdown", (event) => {
      const amplitude = this.#amplitudeAt(event);
      if (amplitude === undefined) return;
      slider.setPointerCapture(event.pointerId);
      moved(amplitude);
    });
    slider.addEventListener("pointermove", (event) => {
      const amplitude = this.#amplitudeAt(event);
      under(amplitude);
      if (amplitude !== undefined && slider.hasPointerCapture(event.pointerId)) moved(amplitude);
    });
    slider.addEventListener("pointerleave", () => under(undefined));
    slider.addEventListener("keydown", (event) => {
      const step = event.shiftKey ? 0.1 : 1;
      const steps: Record<string, number> = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity };
      const by = steps[event.key];
      if (by === undefined) return;
      event.preventDefault();
      moved(this.#within(Math.round((this.#amplitude + by) * 10) / 10));
    });
  }

  #amplitudeAt(event: MouseEvent): number | undefined {
    const [place, frame] = [this.picture.at(event), this.picture.frame()];
    if (place === undefined || frame === undefined) return undefined;
    const part = (place.x - frame.left) / (frame.right - frame.left);
    if (part < 0 || part > 1 || place.y < frame.top || place.y > frame.bottom) return undefined;
    return this.#within(Math.round((this.#axes.from + part * (this.#axes.to - this.#axes.from)) * 10) / 10);
  }

  // At the top itself there is no period.
  #within(amplitude: number): number {
    return Math.min(Math.max(amplitude, this.#axes.from, 0.1), Math.min(this.#axes.to, 179.9));
  }
}
