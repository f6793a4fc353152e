// The controls of time.

import { button, element } from "../../parts/element.ts";
import { choiceField } from "../../parts/field.ts";
import { type Icon, icon } from "../../parts/icon.ts";
import { text } from "../../texts/en.ts";
import type { Clock } from "../../parts/clock.ts";

const words = text.pendulum.transport;

/** One step, in frames of a sixtieth of a second at the chosen speed. */
const STEP = 1 / 60;

export class Transport {
  readonly element: HTMLElement;
  readonly #clock: Clock;
  readonly #changed: () => void;
  readonly #run: HTMLButtonElement;
  readonly #speed = choiceField({ key: "speed", words: { label: words.speed }, initial: "1" }, words.speeds.map(([value = "", name = ""]) => [value, name] as const));
  readonly #reverse: HTMLButtonElement;

  /** `changed` is called when the time was changed by hand, or has begun or ceased to run. */
  constructor(clock: Clock, speed: string, changed: () => void) {
    [this.#clock, this.#changed] = [clock, changed];
    const picture = (name: Icon, label: string, pressed: () => void, attributes = {}) => {
      const made = button("", pressed, { class: "icon", "aria-label": label, title: label, ...attributes });
      made.append(icon(name));
      return made;
    };
    this.#run = picture("play", words.play, () => this.toggle(), { class: "main run icon" });
    this.#reverse = picture("reverse", words.reverse, () => this.#turn(), { "aria-pressed": "false" });
    this.#speed.value = speed;
    this.#clock.speed = Number(speed) || 1;
    this.#speed.onChange(() => this.#set());
    this.element = element(
      "div",
      { class: "bench-time", role: "group", "aria-label": words.group },
      picture("restart", words.restart, () => this.restart()),
      picture("back", words.back, () => this.step(-1)),
      this.#run,
      picture("forth", words.forth, () => this.step(1)),
      this.#reverse,
      this.#speed.element,
    );
  }

  get speed(): string {
    return this.#speed.value;
  }

  toggle(): void {
    if (this.#clock.isRunning) this.#clock.stop();
    else this.#clock.run();
    this.show();
    this.#changed();
  }

  restart(): void {
    this.#clock.time = 0;
    this.#changed();
  }

  step(sign: number): void {
    this.#clock.stop();
    this.#clock.time = Math.max(0, this.#clock.time + sign * STEP * Math.abs(this.#clock.speed));
    this.show();
    this.#changed();
  }

  /** Shows whether the time runs. */
  show(): void {
    const label = this.#clock.isRunning ? words.pause : words.play;
    if (this.#run.title === label) return;
    this.#run.title = label;
    this.#run.setAttribute("aria-label", label);
    this.#run.replaceChildren(icon(this.#clock.isRunning ? "pause" : "play"));
  }

  /** Handles the keys of the stage, except where text is entered; returns `true` for such a key. */
  key(event: KeyboardEvent): boolean {
    const target = event.target as HTMLElement;
    const isBusy = target.closest("input:not([type=range]), select, textarea, summary, a") !== null || (event.key === " " && target.closest("button, input") !== null);
    if (isBusy || event.ctrlKey || event.altKey || event.metaKey) return false;
    const actions: Record<string, () => void> = { " ": () => this.toggle(), ",": () => this.step(-1), ".": () => this.step(1), Home: () => this.restart() };
    const action = actions[event.key];
    action?.();
    return action !== undefined;
  }

  #turn(): void {
    this.#clock.speed = -this.#clock.speed;
    this.#reverse.setAttribute("aria-pressed", String(this.#clock.speed < 0));
    this.#changed();
  }

  #set(): void {
    this.#clock.speed = Math.sign(this.#clock.speed) * Number(this.#speed.value || "1");
    this.#changed();
  }
}
