// Files that the page offers for saving.

import type { Answer } from "../engine/engine.ts";
import { text } from "../texts/en.ts";
import { reason, unmarked } from "./marks.ts";
import { plain } from "./plain.ts";

/** Offers bytes or text as a file with this name; texts are in the words of the command. */
export function save(name: string, content: Uint8Array | string, type: string): void {
  const written = type.startsWith("text/") && typeof content !== "string" ? unmarked(new TextDecoder().decode(content)) : content;
  const place = URL.createObjectURL(new Blob([written as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = place;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(place), 10_000);
}

/** Offers a result as a file; returns the reason if it is empty or failed. */
export function saveAnswer(name: string, answer: Answer, type: string): string {
  if (answer.status !== 0 || answer.output.length === 0) return plain(reason(answer.error)) || text.parts.nothingToSave;
  save(name, answer.output, type);
  return "";
}
