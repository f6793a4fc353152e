// The fields of the room.

import { choiceField, type Field, textField } from "../../parts/field.ts";
import { unitSwitch } from "../../parts/unit_switch.ts";
import { text } from "../../texts/en.ts";

const words = text.formulas;
const LOWEST = ["1e-3", "1e-5", "1e-8", "1e-12", "1e-16", "1e-30"];

export function fields(): Field[] {
  return [
    textField({ key: "amplitude", option: "AMPLITUDE", words: words.amplitude, initial: "60deg", unit: "angle", isShort: true }),
    textField({ key: "tolerance", option: "--tolerance", words: words.tolerance, initial: "1e-3" }),
    unitSwitch(),
    textField({ key: "from", option: "--from", words: words.from, initial: "0deg", unit: "angle", isShort: true }),
    textField({ key: "to", option: "--to", words: words.to, initial: "180deg", unit: "angle", isShort: true }),
    choiceField({ key: "lowest", option: "--lowest", words: words.lowest, initial: "1e-8" }, LOWEST.map((value) => [value, value])),
  ];
}
