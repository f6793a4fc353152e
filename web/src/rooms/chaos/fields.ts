// The fields of the room: a system, a range of a parameter, a value in it; and example systems.

import { choiceField, type Field, textField } from "../../parts/field.ts";
import { plainly } from "../../parts/plain.ts";
import { text } from "../../texts/en.ts";

const words = text.chaos;

type Preset = keyof typeof words.presets;

/** The entries of each preset; fields that are not named are emptied. */
const PRESETS: Readonly<Record<Preset, Readonly<Record<string, string>>>> = {
  routes: { system: "driven_pendulum", set: "c=1/2", initial: "theta=0.2; theta=0.2001", over: "A=1:1.5:0.0025", each: "60", sweep: "both", value: "1.2" },
  chaotic: { system: "driven_pendulum", set: "c=1/2", initial: "theta=0.2; theta=0.2001", over: "A=1:1.5:0.0025", each: "60", sweep: "both", value: "1.5", points: "10000" },
  upright: { system: "vertically_driven_pendulum", set: "omega=20,c=1/10", initial: "theta=170deg; theta=171deg", over: "a=0.02:0.12:0.002", value: "0.1", points: "500", map: "omega=5:30,a=0.02:0.6", rest: "theta=180deg", lines: "0" },
  threshold: { system: "driven_pendulum", set: "c=1/4", initial: "theta=0.2; theta=0.2001", over: "A=0.4:1.2:0.01", value: "0.7", thresholds: "A=0.1:1" },
  springs: { system: "spring_pendulum", set: "kappa=3", initial: "r=1.3733,theta=0.04; r=1.3743,theta=0.04", at: "theta", points: "500", until: "300", order: "5" },
  stars: { system: "henon_heiles", initial: "y=0.1,x'=0.4; y=-0.2,x'=0.4; y=0.3,x'=0.3; x'=0.48", at: "x", points: "600" },
  double: { system: "double_pendulum", initial: "theta1=120deg,theta2=120deg; theta1=120deg,theta2=121deg", at: "sin(theta1)", points: "500", until: "20", intervals: "100" },
  jumps: { system: "driven_pendulum", set: "A=0.15,c=0.1", initial: "theta=0; theta=2", value: "0.8", over: "omega=0.6:1.2:0.01", sweep: "both", response: "omega=0.3:1.4", map: "omega=0.7:1,A=0.05:0.4" },
  thirds: { system: "x'' + 0.15 x' + x + x^3 = 5 cos(w t)", initial: "x=-0.58,x'=-1.87; x=0", over: "w=2.5:6:0.05", value: "4.6", each: "10", points: "500", response: "w=2.5:6", orders: "1/3" },
  lorenz: { system: "lorenz", initial: "x=1,y=1,z=1; x=1.001,y=1,z=1", over: "rho=20:30:0.25", value: "28", at: "z - 27", points: "1000", until: "30", intervals: "1000" },
};

/** The entries of the fields that a preset does not name. */
const PLAIN = { set: "", at: "", over: "", value: "", sweep: "both", response: "", orders: "", map: "", rest: "", lines: "3", thresholds: "", periods: "5", order: "", about: "", each: "60", points: "2000", until: "100", intervals: "300" };

/** All values of a preset. */
export function preset(key: string): Readonly<Record<string, string>> | undefined {
  const chosen = PRESETS[key as Preset];
  return chosen === undefined ? undefined : { ...PLAIN, ...chosen };
}

export const PARTS = {
  system: ["system", "set", "initial", "at"],
  diagram: ["over", "each", "sweep"],
  chosen: ["value", "points", "until", "intervals"],
  response: ["response", "orders"],
  map: ["map", "rest", "lines"],
  melnikov: ["thresholds", "periods"],
  exchange: ["order", "about"],
} as const;

/** The label of the first field of an option. */
export function labelOf(option: string): string | undefined {
  return fields().find((field) => field.option === `--${option}`)?.label;
}

export function fields(): Field[] {
  const { sweep } = words;
  const all = [
    textField({ key: "system", option: "SYSTEM|EQUATION", words: words.system, initial: "driven_pendulum" }),
    textField({ key: "set", option: "--set", words: words.set, initial: "c=1/2" }),
    textField({ key: "initial", option: "--initial", words: words.initial, initial: "theta=0.2; theta=0.2001" }),
    textField({ key: "at", option: "--at", words: words.at }),
    textField({ key: "over", option: "--over", words: words.over, initial: "A=1:1.5:0.0025" }),
    textField({ key: "each", option: "--points", words: words.each, initial: "60" }),
    choiceField({ key: "sweep", option: "--sweep", words: { label: sweep.label }, initial: "both" }, [["", sweep.none], ["up", sweep.up], ["down", sweep.down], ["both", sweep.both]]),
    textField({ key: "value", words: words.value, initial: "1.2" }),
    textField({ key: "points", option: "--points", words: words.points, initial: "2000" }),
    textField({ key: "until", option: "--to", words: words.until, initial: "100" }),
    textField({ key: "intervals", option: "--intervals", words: words.intervals, initial: "300" }),
    textField({ key: "response", option: "--over", words: words.response }),
    textField({ key: "orders", option: "--orders", words: words.orders }),
    textField({ key: "map", option: "--map", words: words.map }),
    textField({ key: "rest", option: "--initial", words: words.rest }),
    textField({ key: "lines", option: "--lines", words: words.lines, initial: "3" }),
    textField({ key: "thresholds", option: "--over", words: words.thresholds }),
    textField({ key: "periods", option: "--max-drive-periods", words: words.periods, initial: "5" }),
    textField({ key: "order", option: "--order", words: words.order }),
    textField({ key: "about", option: "--about", words: words.about }),
  ];
  return all.map((field) => plainly(field, labelOf));
}
