// A query as data, from which the words of the query, the line for a shell and the line for Python are made.

import type { Answer, Engine, Question } from "../engine/engine.ts";

/** A query of the command with its arguments and options; flags have the value `true`. */
export interface Command {
  /** The name of the query, such as `fit trace`. */
  readonly question: string;
  readonly arguments?: readonly string[];
  readonly options?: readonly Option[];
}

export type Option = readonly [name: string, value: string | true];

/** The options that have a value. */
export function given(options: Readonly<Record<string, string | boolean | undefined>>): Option[] {
  return Object.entries(options).flatMap(([name, value]): Option[] =>
    value === undefined || value === "" || value === false ? [] : [[name, value]],
  );
}

/** The words of the command line after `libration`. */
export function words({ question, arguments: places = [], options = [] }: Command): string[] {
  const named = options.flatMap(([name, value]) => {
    if (value === true) return [`--${name}`];
    return value.startsWith("-") && value !== "-" ? [`--${name}=${value}`] : [`--${name}`, value];
  });
  const guard = places.some((place) => place.startsWith("-") && place !== "-") ? ["--"] : [];
  return [...question.split(" "), ...(guard.length > 0 ? [...named, ...guard, ...places] : [...places, ...named])];
}

/** The same query with further options. */
export function extended(command: Command, options: Readonly<Record<string, string | boolean | undefined>>): Command {
  return { ...command, options: [...(command.options ?? []), ...given(options)] };
}

/** Runs the query. */
export function ask(engine: Engine, command: Command, how: Omit<Question, "words"> = {}): Promise<Answer> {
  return engine.ask({ words: words(command), ...how });
}

/** The line for a shell. */
export function shellLine(command: Command): string {
  return ["libration", ...words(command)].map(quotedForShell).join(" ");
}

function quotedForShell(word: string): string {
  if (/^[\w@%+=:,./^±°-]+$/u.test(word)) return word;
  if (!/["$`\\!]/.test(word)) return `"${word}"`;
  return `'${word.replaceAll("'", "'\\''")}'`;
}

/** Options for the form of the output; in Python the result is an object. */
const FORMS = new Set(["json", "csv", "latex"]);

/** The line for Python, after `from libration import questions`. */
export function pythonLine({ question, arguments: places = [], options = [] }: Command): string {
  const values = new Map<string, (string | true)[]>();
  for (const [name, value] of options) {
    if (FORMS.has(name) || (question === "expand" && name === "format") || (question.startsWith("figure ") && name === "output")) continue;
    values.set(name, [...(values.get(name) ?? []), value]);
  }
  const keyword = (name: string) => (name === "from" || name === "lambda" ? `${name}_` : name.replaceAll("-", "_"));
  const named = Array.from(values, ([name, all]) => `${keyword(name)}=${pythonValue(all)}`);
  const positional = places.length > 1 ? [pythonValue(places)] : places.map((place) => pythonText(place));
  const name = question === "list" ? "list_" : question.replaceAll(" ", "_");
  return `questions.${name}(${[...positional, ...named].join(", ")})`;
}

function pythonValue(values: readonly (string | true)[]): string {
  const written = values.map((value) => (value === true ? "True" : pythonText(value)));
  return written.length === 1 ? (written[0] ?? "") : `[${written.join(", ")}]`;
}

function pythonText(text: string): string {
  return JSON.stringify(text);
}
