// The pendulum itself: drawn, dragged, thrown, and turned by keys.

import { element } from "../../parts/element.ts";
import { type Colour, type Colours, colours } from "../../parts/colours.ts";

export interface Shown {
  readonly angle: number;
  readonly ghosts: readonly { readonly angle: number; readonly colour: Colour }[];
}

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
  #shown: Shown = { angle: 0, ghosts: [] };

  constructor(label: string, hands: Hands) {
    this.canvas = element("canvas", { class: "stage", tabindex: "0", role: "slider", "aria-label": label, "aria-valuemin": "-180", "aria-valuemax": "180", "aria-valuenow": "0" });
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

  show(shown: Shown): void {
    this.#shown = shown;
    this.#draw();
  }

  redraw(): void {
    this.#colours = colours();
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
    const [x, y, length] = [width / 2, height / 2, 0.42 * Math.min(width, height)];
    context.clearRect(0, 0, width, height);
    context.strokeStyle = this.#colours.line;
    context.lineWidth = 1;
    context.beginPath();
    context.arc(x, y, length, 0, 2 * Math.PI);
    context.moveTo(x, y - 1.12 * length);
    context.lineTo(x, y + 1.12 * length);
    context.stroke();
    for (const ghost of this.#shown.ghosts) this.#rod(context, x, y, length, ghost.angle, ghost.colour, false);
    this.#rod(context, x, y, length, this.#shown.angle, "curve-1", true);
    context.fillStyle = this.#colours.ink;
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
  }

  #rod(context: CanvasRenderingContext2D, x: number, y: number, length: number, angle: number, colour: Colour, solid: boolean): void {
    const [bobX, bobY] = [x + length * Math.sin(angle), y + length * Math.cos(angle)];
    context.strokeStyle = this.#colours[solid ? "ink" : colour];
    context.lineWidth = solid ? 3 : 1.5;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(bobX, bobY);
    context.stroke();
    context.beginPath();
    context.arc(bobX, bobY, Math.max(8, length * (solid ? 0.09 : 0.065)), 0, 2 * Math.PI);
    if (solid) {
      context.fillStyle = this.#colours[colour];
      context.fill();
    } else {
      context.strokeStyle = this.#colours[colour];
      context.lineWidth = 2;
      context.stroke();
    }
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
