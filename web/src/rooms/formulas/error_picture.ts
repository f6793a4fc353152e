// The errors of the formulas against the amplitude, with the reader's amplitude and tolerance.

import type { Engine } from "../../engine/engine.ts";
import { type Command, given } from "../../parts/command.ts";
import { Picture } from "../../parts/picture.ts";
import { type Axis, PictureSlider } from "../../parts/picture_slider.ts";
import { text } from "../../texts/en.ts";

/** The axes as entered. */
export interface Axes {
  readonly from: string | undefined;
  readonly to: string | undefined;
  readonly lowest: number;
}

/** The upper end of the axis of errors. */
const HIGHEST = 10;
export class ErrorPicture {
  readonly picture: Picture;
  readonly #slider: PictureSlider;
  #lowest = 1e-8;
  #tolerance = 1e-3;

  /** `moved` receives the amplitude in degrees, `under` that under the pointer, or `undefined` when it leaves. */
  constructor(engine: Engine, nearest: (amplitude: number) => number, moved: (amplitude: number) => void, under: (amplitude: number | undefined) => void) {
    this.picture = new Picture(engine, "errors", "output");
    this.#slider = new PictureSlider(this.picture, text.formulas.pictureLabel, { moved, under, nearest, steps: () => ({ usual: 1, fine: 0.1, coarse: 10 }) });
  }

  command(keys: readonly string[], axes: Axes): Command {
    this.#lowest = axes.lowest;
    const lowest = axes.lowest === 1e-8 ? undefined : axes.lowest.toExponential(0);
    return { question: "figure errors", options: given({ formulas: keys.join(","), from: axes.from, to: axes.to, lowest }) };
  }

  /** Marks the amplitude, in degrees, and the tolerance, with the amplitude in words. */
  mark(amplitude: number, tolerance: number, words: string): void {
    this.#tolerance = tolerance;
    this.#slider.axis = this.#axis();
    this.#slider.put(amplitude, words);
    this.lines();
  }

  /** Redraws the lines, such as after the picture has changed. */
  lines(): void {
    const frame = this.picture.frame();
    if (frame === undefined) return;
    this.#slider.axis = this.#axis();
    const y = frame.bottom - (Math.log(this.#tolerance / this.#lowest) / Math.log(HIGHEST / this.#lowest)) * (frame.bottom - frame.top);
    const limit: [string, string][] = y >= frame.top && y <= frame.bottom ? [["limit", `M${frame.left} ${y}H${frame.right}`]] : [];
    this.picture.overlay([...this.#slider.line(), ...limit]);
  }

  /** The amplitudes at both ends, in degrees: those of the picture, once there is one. */
  #axis(): Axis {
    return this.picture.axis() ?? { from: 0, to: 180 };
  }
}
