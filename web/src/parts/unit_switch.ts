// Degrees or radians, for the angles that are shown.

import { text } from "../texts/en.ts";
import { choiceField, type Field } from "./field.ts";

export function unitSwitch(): Field {
  const { label, degrees, radians } = text.parts.unit;
  return choiceField({ key: "unit", words: { label }, initial: "deg" }, [["deg", degrees], ["rad", radians]]);
}
