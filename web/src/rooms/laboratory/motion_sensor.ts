// A phone's gyroscope as an instrument: its readings as a file, like those of other instruments.

import { button, element } from "../../parts/element.ts";
import { text } from "../../texts/en.ts";

const words = text.laboratory.sensor;
/** Time without a reading after which no gyroscope is assumed, in milliseconds. */
const PATIENCE = 2000;
/** Minimum number of readings in a recording. */
const FEWEST = 20;

type Axis = "alpha" | "beta" | "gamma";
interface Reading extends Readonly<Record<Axis, number>> {
  readonly seconds: number;
}

export class MotionSensor {
  readonly element: HTMLElement;
  readonly #button = button(words.record, () => void this.#press());
  readonly #status = element("p", { role: "status" });
  readonly #recorded: (name: string, bytes: Uint8Array) => void;
  readonly #listener = (event: DeviceMotionEvent) => this.#take(event);
  #readings: Reading[] | undefined;

  constructor(recorded: (name: string, bytes: Uint8Array) => void) {
    this.#recorded = recorded;
    const why = reasonAgainst();
    this.element = element("details", { class: "fields" }, element("summary", {}, words.title), element("p", {}, words.lead), this.#button, this.#status);
    this.#button.disabled = why !== undefined;
    this.#status.textContent = why ?? "";
  }

  /** Stops listening. */
  leave(): void {
    removeEventListener("devicemotion", this.#listener);
    this.#readings = undefined;
  }

  async #press(): Promise<void> {
    if (this.#readings !== undefined) return this.#finish();
    if (!(await isAllowed())) return this.#say(words.refused);
    this.#readings = [];
    addEventListener("devicemotion", this.#listener);
    this.#button.textContent = words.stop;
    setTimeout(() => {
      if (this.#readings?.length !== 0) return;
      this.#end();
      this.#say(words.silent);
    }, PATIENCE);
  }

  #take({ rotationRate, timeStamp }: DeviceMotionEvent): void {
    const { alpha, beta, gamma } = rotationRate ?? {};
    if (this.#readings === undefined || alpha == null || beta == null || gamma == null) return;
    this.#readings.push({ seconds: timeStamp / 1000, alpha, beta, gamma });
    const [first] = this.#readings;
    this.#say(words.recording(timeStamp / 1000 - (first?.seconds ?? 0), this.#readings.length));
  }

  #finish(): void {
    const readings = this.#end();
    if (readings.length < FEWEST) return this.#say(words.still);
    const axis = (["alpha", "beta", "gamma"] as const).reduce((best, it) => (spread(readings, it) > spread(readings, best) ? it : best));
    this.#say(words.taken(words.axes[axis]));
    this.#recorded(words.file, new TextEncoder().encode(written(readings, axis)));
  }

  #end(): Reading[] {
    const readings = this.#readings ?? [];
    this.leave();
    this.#button.textContent = words.record;
    return readings;
  }

  #say(sentence: string): void {
    this.#status.textContent = sentence;
  }
}

/** Readings of one axis as a table with names and units; times start at the first reading. */
export function written(readings: readonly Reading[], axis: Axis): string {
  const start = readings[0]?.seconds ?? 0;
  const lines = readings.map((reading) => `${(reading.seconds - start).toFixed(4)},${reading[axis]}`);
  return `time (s),angular velocity (deg/s)\n${lines.join("\n")}\n`;
}

function spread(readings: readonly Reading[], axis: Axis): number {
  return readings.reduce((sum, reading) => sum + reading[axis] ** 2, 0);
}

function reasonAgainst(): string | undefined {
  if (!isSecureContext) return words.insecure;
  return "DeviceMotionEvent" in globalThis ? undefined : words.missing;
}

// Only some browsers ask the reader, and only after a press.
async function isAllowed(): Promise<boolean> {
  const { requestPermission } = DeviceMotionEvent as unknown as { requestPermission?: () => Promise<string> };
  if (requestPermission === undefined) return true;
  return (await requestPermission().catch(() => "denied")) === "granted";
}
