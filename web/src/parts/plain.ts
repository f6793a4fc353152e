// Sentences of the command in the words of the page: labels of fields instead of options, quotation marks instead of backticks.

import { text } from "../texts/en.ts";
import type { Field } from "./field.ts";

/** The name that an option, without its dashes, or a command has on the page. */
export type Labels = (name: string) => string | undefined;

/** The sentence without remarks that only name options, with labels for those that remain. */
export function plain(sentence: string, label: Labels = () => undefined): string {
  return sentence
    .replace(/\s*\((?:without )?--[^()]*\)/g, "")
    .replace(/`([^`]*)`/g, (_, quoted: string) => (quoted.trim() === "" ? text.parts.emptyEntry : `“${quoted}”`))
    .replace(/\blibration ((?:fit )?[a-z]+)/g, (_, command: string) => `“${label(command) ?? command}”`)
    .replace(/--([a-z][a-z-]*)/g, (_, option: string) => `“${label(option) ?? option.replaceAll("-", " ")}”`);
}

/** The same field, with its error messages in the words of the page. */
export function plainly(field: Field, label?: Labels): Field {
  const refuse = field.refuse.bind(field);
  field.refuse = (reason) => refuse(plain(reason, label));
  return field;
}
