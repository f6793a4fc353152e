// Degrees or radians, for the angles that are shown and for those that are entered without a unit.

import { text } from "../texts/en.ts";
import { choiceField, type Field } from "./field.ts";

/** The key of the switch. */
export const UNIT = "unit";

export function unitSwitch(): Field {
  const { label, degrees, radians } = text.parts.unit;
  return choiceField({ key: UNIT, words: { label }, initial: "deg" }, [["deg", degrees], ["rad", radians]]);
}
