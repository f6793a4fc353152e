// The harmonics of the swing as a tone: small swings sound pure at 220 Hz, wide ones lower and brighter.

import type { Harmonics } from "../../engine/mathematics.ts";

const SMALL_SWINGS = 220;

export class Tone {
  #context: AudioContext | undefined;
  #oscillator: OscillatorNode | undefined;

  get sounds(): boolean {
    return this.#oscillator !== undefined;
  }

  /** `frequencyRatio` is T₀/T. */
  play({ terms }: Harmonics, frequencyRatio: number): void {
    this.stop();
    const context = (this.#context ??= new AudioContext());
    const last = terms.at(-1)?.n ?? 0;
    if (last === 0 || frequencyRatio <= 0) return;
    const real = new Float32Array(last + 1);
    for (const { n, angle } of terms) real[n] = angle;
    const oscillator = context.createOscillator();
    oscillator.setPeriodicWave(context.createPeriodicWave(real, new Float32Array(last + 1)));
    oscillator.frequency.value = SMALL_SWINGS * frequencyRatio;
    const volume = context.createGain();
    volume.gain.value = 0.15;
    oscillator.connect(volume).connect(context.destination);
    oscillator.start();
    this.#oscillator = oscillator;
  }

  stop(): void {
    this.#oscillator?.stop();
    this.#oscillator = undefined;
  }

  close(): void {
    this.stop();
    void this.#context?.close();
  }
}
