// Sentences of the command in the words of a room: its labels in place of options, and words in place of keys.

import { text } from "../texts/en.ts";
import type { Field } from "./field.ts";
import { labels, plain } from "./plain.ts";

/** The sentence with words in place of keys. */
export function withoutKeys(sentence: string): string {
  return text.parts.keys.reduce((written, [key, words]) => written.replaceAll(key, words), sentence);
}

/** Sets the error messages of the fields in the words of their room; returns these words for any other sentence. */
export function inWords(fields: readonly Field[]): (sentence: string) => string {
  const said = (sentence: string) => withoutKeys(plain(sentence, labels(fields)));
  for (const field of fields) {
    const refuse = field.refuse.bind(field);
    field.refuse = (reason) => refuse(said(reason));
  }
  return said;
}
