// Sentences of the command in the words of the page: labels of fields in place of options, quotation marks in place of backticks.

import { text } from "../texts/en.ts";
import type { Field } from "./field.ts";
import { marks } from "./marks.ts";

/** The name that an option, without its dashes, or a query has on the page. */
export type Labels = (name: string) => string | undefined;

/** A sentence with marks as the page says it. */
export function plain(sentence: string, label: Labels = () => undefined): string {
  const named = marks(sentence).map((it) => {
    if (typeof it === "string") return it.replace(/`([^`]*)`/g, (_, quoted: string) => (quoted.trim() === "" ? text.parts.emptyEntry : `“${quoted}”`));
    const name = `“${label(it.name) ?? text.parts.queries[it.name] ?? it.name.replaceAll("-", " ")}”`;
    return it.values.length === 0 ? name : `${name} ${text.parts.alternatives(it.values)}`;
  });
  return named.join("");
}

/** The labels of these fields, by their options. */
export function labels(fields: Iterable<Field>): Labels {
  const all = [...fields];
  return (name) => all.find(({ option }) => option === `--${name}`)?.label;
}

/** The same field, with its error messages in the words of the page. */
export function plainly(field: Field, label?: Labels): Field {
  const refuse = field.refuse.bind(field);
  field.refuse = (reason) => refuse(plain(reason, label));
  return field;
}
