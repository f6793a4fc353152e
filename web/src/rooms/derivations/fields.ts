// The fields of the room, and those that belong to each method.

import { choiceField, type Field, textField, tickField } from "../../parts/field.ts";
import { text } from "../../texts/en.ts";
import { SUGGESTIONS } from "../perturbation/gauge.ts";

const words = text.derivations;

export const ROADS = ["short", "elliptic", "formulas", "perturbation", "averaging", "limit-cycle"] as const;

/** The fields that a method takes in addition to the common ones. */
const TAKEN: Readonly<Record<string, readonly string[]>> = {
  short: ["amplitude", "length", "gravity", "exercises"],
  elliptic: ["amplitude", "length", "gravity", "exercises"],
  formulas: ["amplitude", "length", "gravity", "exercises"],
  perturbation: ["oscillator", "order", "gauge", "set", "about", "amplitude", "length", "gravity", "exercises"],
  averaging: ["oscillator", "order", "damping-order", "small", "resonance", "set", "exercises"],
  "limit-cycle": ["oscillator", "order", "small", "set", "exercises"],
  paper: ["document", "only", "label"],
};

export function taken(road: string): readonly string[] {
  return TAKEN[road] ?? [];
}

export const SERIES_KEYS = ["oscillator", "order", "damping-order", "small", "resonance", "gauge", "set", "about"];
export const OWN_KEYS = ["amplitude", "length", "gravity", "exercises"];
export const PAPER_KEYS = ["document", "only", "label"];

export function fields(): Field[] {
  const { road, document, only } = words;
  const roads = [...ROADS, "paper"] as const;
  return [
    choiceField({ key: "road", words: { label: road.label, hint: road.hint }, initial: "short" }, roads.map((key) => [key, road[key]])),
    textField({ key: "oscillator", option: "OSCILLATOR|EQUATION", words: words.oscillator }),
    textField({ key: "order", option: "--order", words: words.order }),
    textField({ key: "damping-order", option: "--damping-order", words: words.dampingOrder }),
    textField({ key: "small", option: "--small", words: words.small }),
    textField({ key: "resonance", option: "--resonance", words: words.resonance }),
    textField({ key: "gauge", option: "--gauge", words: words.gauge }, SUGGESTIONS),
    textField({ key: "set", option: "--set", words: words.set }),
    textField({ key: "about", option: "--about", words: words.about }),
    textField({ key: "amplitude", option: "--amplitude", words: words.amplitude, unit: "angle", isShort: true }),
    textField({ key: "length", option: "--length", words: words.length, unit: "m", isShort: true }),
    textField({ key: "gravity", option: "--gravity", words: words.gravity, unit: "m/s^2", isShort: true }),
    tickField({ key: "exercises", option: "--exercises", words: words.exercises }),
    choiceField({ key: "document", option: "--document", words: { label: document.label } }, [["", document.all], ["black-vel", document["black-vel"]], ["cote", document.cote]]),
    choiceField({ key: "only", option: "--only", words: { label: only.label } }, [
      ["", only.all],
      ...(["verified", "typo", "wrong", "not-decided"] as const).map((verdict): [string, string] => [verdict, only[verdict]]),
    ]),
    textField({ key: "label", option: "--label", words: words.label }),
  ];
}
