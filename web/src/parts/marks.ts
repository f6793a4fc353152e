// Marks in the sentences of the command, which name parameters and queries (`MarkedWords` in crates/libration-queries/src/query_error/text.rs).

import type { Part, QueryError } from "../engine/engine.ts";

/** An option without its dashes, or a query; the values of an option of which each would do. */
export interface Mark {
  readonly name: string;
  readonly values: readonly string[];
}

/** The beginning of a mark, its end, and what encloses each value in it. */
const [BEGIN, END, VALUE] = ["\uE000", "\uE001", "\uE002"];

/** The sentence as texts and marks. */
export function marks(sentence: string): (string | Mark)[] {
  return sentence.split(BEGIN).flatMap((part, place): (string | Mark)[] => {
    const end = part.indexOf(END);
    return place === 0 || end < 0 ? [part] : [mark(part.slice(0, end)), part.slice(end + 1)];
  });
}

function mark(written: string): Mark {
  const [name = "", ...parts] = written.split(VALUE);
  return { name: name.replace(/^(--|libration )|[ "]+$/g, ""), values: parts.filter((_, place) => place % 2 === 0 && place < parts.length - 1) };
}

/** The text in the words of the command line. */
export function unmarked(text: string): string {
  return text.replaceAll(/[\uE000-\uE002]/g, "");
}

/** The message of an error with its subject and its hint, with marks, without the parameters that it is about. */
export function explained({ subject, message, hint }: QueryError): string {
  return [subject === "" ? message : [`${subject}: `, ...message], hint].filter((parts) => parts.length > 0).map((parts) => parts.map(marked).join("")).join("\n");
}

/** The same after the parameters that it is about. */
export function reason(error: QueryError): string {
  const about = error.parameters.map((parameter) => marked({ parameter })).join(", ");
  return `${about}${about === "" ? "" : ": "}${explained(error)}`;
}

function marked(part: Part): string {
  if (typeof part === "string") return part;
  if ("query" in part) return `${BEGIN}libration ${part.query}${END}`;
  const values = part.values ?? [];
  return `${BEGIN}${part.parameter}${values.length > 0 ? " " : ""}${values.map((value) => `${VALUE}${value}${VALUE}`).join("|")}${END}`;
}
