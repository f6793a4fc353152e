// The fields of the room: the oscillator, the expansion, and the amplitude of its evaluation.

import { choiceField, type Field, textField } from "../../parts/field.ts";
import { unitSwitch } from "../../parts/unit_switch.ts";
import { text } from "../../texts/en.ts";
import { SUGGESTIONS } from "./gauge.ts";

const words = text.perturbation;

/** Default amplitudes for oscillators whose variable is an angle. */
export const ANGLES = { evaluate: "60deg", amplitudes: "10deg:170deg:10deg" } as const;
/** The same for oscillators whose variable is not an angle: amplitudes at which all of the catalogue oscillate. */
export const PLAIN = { evaluate: "0.4", amplitudes: "0.05:0.4:0.05" } as const;

/** Default order of a series. */
export const ORDER = "7";

export function fields(): Field[] {
  const { quantity } = words;
  const harmonics = [1, 2, 3, 5, 7].map((n): [string, string] => [`a${n}`, quantity.harmonic(n)]);
  return [
    textField({ key: "oscillator", option: "OSCILLATOR|EQUATION", words: words.oscillator, initial: "pendulum" }),
    textField({ key: "set", option: "--set", words: words.set }),
    textField({ key: "letters", option: "--letters", words: words.letters }),
    textField({ key: "about", option: "--about", words: words.about }),
    textField({ key: "order", option: "--order", words: words.order, initial: ORDER }),
    textField({ key: "gauge", option: "--gauge", words: words.gauge }, SUGGESTIONS),
    textField({ key: "damping-order", option: "--damping-order", words: words.dampingOrder }),
    textField({ key: "small", option: "--small", words: words.small }),
    textField({ key: "resonance", option: "--resonance", words: words.resonance }),
    textField({ key: "evaluate", option: "--evaluate", words: words.evaluate, initial: ANGLES.evaluate, unit: "angle" }),
    choiceField({ key: "quantity", option: "--quantity", words: { label: quantity.label }, initial: "period" }, [
      ["period", quantity.period],
      ["frequency", quantity.frequency],
      ...harmonics,
    ]),
    textField({ key: "amplitudes", option: "--amplitudes", words: words.amplitudes, initial: ANGLES.amplitudes, unit: "angle" }),
    unitSwitch(),
  ];
}
