// Files that the page offers for saving.

import type { Answer } from "../engine/engine.ts";
import { text } from "../texts/en.ts";
import { reason } from "./command.ts";

/** Offers bytes or text as a file with this name. */
export function save(name: string, content: Uint8Array | string, type: string): void {
  const place = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = place;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(place), 10_000);
}

/** Offers a result as a file; returns the reason if it is empty or failed. */
export function saveAnswer(name: string, answer: Answer, type: string): string {
  if (answer.status !== 0 || answer.output.length === 0) return reason(answer) || text.parts.nothingToSave;
  save(name, answer.output, type);
  return "";
}
