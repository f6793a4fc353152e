// The reason of a failure in the words of the room.

import type { Answer } from "../../engine/engine.ts";
import { explained } from "../../parts/marks.ts";
import { plain } from "../../parts/plain.ts";
import { labelOf } from "./fields.ts";

export function said(answer: Answer): string {
  return plain(explained(answer.error), labelOf);
}
