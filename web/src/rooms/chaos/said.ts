// The reason of a failure in the words of the room.

import type { Answer } from "../../engine/engine.ts";
import { explained } from "../../parts/marks.ts";
import { plain } from "../../parts/plain.ts";
import { labelOf } from "./fields.ts";

export function said(answer: Answer): string {
  // The subject of an error without a field is the query, whose part of the results shows it.
  return plain(explained({ ...answer.error, subject: "" }), labelOf);
}
