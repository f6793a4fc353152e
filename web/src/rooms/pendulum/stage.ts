// The pendulum itself: dragged, thrown, and turned by keys.

import { element } from "../../parts/element.ts";
import { type Colours, colours } from "../../parts/colours.ts";
import { draw, framed, type Frame, type Shown } from "./drawing.ts";

export interface Hands {
  /** Called while the bob is held at this angle in rad, within (−π, π]. */
  held(angle: number): void;
  /** Called when the bob is let go with this velocity in rad/s. */
  letGo(angle: number, velocity: number): void;
  /** Called when the system takes the pointer away: the bob is neither let go nor thrown. */
  taken(): void;
  /** Called when keys turn the angle of release, in degrees. */
  turned(degrees: number): void;
}

/** Smallest velocity of a throw, in rad/s; slower releases are from rest. */
const STILL = 0.3;

export class Stage {
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D | null;
  readonly #observer: ResizeObserver;
  #colours: Colours = colours();
  #letters = "";
  #shown: Shown = { pendulums: [], ghosts: [], arrows: false, gate: undefined, protractor: false, unit: "deg" };

  constructor(label: string, hands: Hands) {
    this.canvas = element("canvas", { class: "stage", "data-state": "stage", tabindex: "0", role: "slider", "aria-label": label, "aria-valuemin": "-180", "aria-valuemax": "180", "aria-valuenow": "0" });
    this.element = this.canvas;
    this.#context = this.canvas.getContext("2d");
    this.#observer = new ResizeObserver(() => this.redraw());
    this.#observer.observe(this.canvas);
    this.#listen(hands);
  }

  /** Describes the angle of release for screen readers. */
  describe(degrees: number, words: string): void {
    this.canvas.setAttribute("aria-valuenow", String(degrees));
    this.canvas.setAttribute("aria-valuetext", words);
  }

  /** Draws, and returns the scale of the drawing, relative to what holds the canvas. */
  show(shown: Shown): Frame {
    this.#shown = shown;
    this.#draw();
    const frame = framed(this.canvas.clientWidth, this.canvas.clientHeight, shown.pendulums);
    return { ...frame, x: frame.x + this.canvas.offsetLeft, y: frame.y + this.canvas.offsetTop };
  }

  redraw(): void {
    this.#colours = colours();
    const { fontSize, fontFamily } = getComputedStyle(this.canvas);
    this.#letters = `${fontSize} ${fontFamily}`;
    const scale = Math.min(devicePixelRatio, 2);
    const { clientWidth, clientHeight } = this.canvas;
    [this.canvas.width, this.canvas.height] = [Math.round(clientWidth * scale), Math.round(clientHeight * scale)];
    this.#context?.setTransform(scale, 0, 0, scale, 0, 0);
    this.#draw();
  }

  close(): void {
    this.#observer.disconnect();
  }

  #draw(): void {
    const context = this.#context;
    if (context === null) return;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    draw(context, width, height, this.#shown, this.#colours, this.#letters);
  }

  #angleOf(event: PointerEvent): number {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return Math.atan2(event.clientX - left - width / 2, event.clientY - top - height / 2);
  }

  #listen(hands: Hands): void {
    /** The last movements, from which the velocity of a throw is computed. */
    let moves: { angle: number; at: number }[] = [];
    /** The pointer that holds the bob. */
    let holder: number | undefined;
    const taken = () => {
      if (holder !== undefined) hands.taken();
      holder = undefined;
    };
    const held = (event: PointerEvent) => {
      const last = moves.at(-1)?.angle;
      const angle = this.#angleOf(event);
      const near = last === undefined ? angle : angle + 2 * Math.PI * Math.round((last - angle) / (2 * Math.PI));
      moves = [...moves.filter(({ at }) => event.timeStamp - at < 100), { angle: near, at: event.timeStamp }];
      hands.held(angle);
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || holder !== undefined) return;
      holder = event.pointerId;
      this.canvas.setPointerCapture(event.pointerId);
      moves = [];
      held(event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.pointerId === holder) held(event);
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (event.pointerId !== holder) return;
      holder = undefined;
      const recent = moves.filter(({ at }) => event.timeStamp - at < 100);
      const [first, last] = [recent[0], recent.at(-1)];
      const velocity = first !== undefined && last !== undefined && last.at > first.at ? (1000 * (last.angle - first.angle)) / (last.at - first.at) : 0;
      hands.letGo(this.#angleOf(event), Math.abs(velocity) < STILL ? 0 : velocity);
    });
    this.canvas.addEventListener("pointercancel", taken);
    this.canvas.addEventListener("lostpointercapture", (event) => event.pointerId === holder && taken());
    this.canvas.addEventListener("keydown", (event) => {
      const steps: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 };
      const step = steps[event.key];
      if (step === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      hands.turned(event.shiftKey ? step / 10 : step);
    });
  }
}
