// Queries of the command, run in the page: the same words, and the same bytes as output.

/** A text, or a reference to a parameter or a query of the command, which has another name on the page. */
export type Part = string | { readonly parameter: string; readonly values?: readonly string[] } | { readonly query: string };

/** The reason why a query has no result; absent parts are empty. */
export interface QueryError {
  /** The error in the words of the command; empty if there is none. */
  readonly text: string;
  /** The parameters that the error is about, such as `--order` or `OSCILLATOR|EQUATION`. */
  readonly parameters: readonly string[];
  /** The name of the value that the error is about, for a parameter with several values. */
  readonly item: string;
  /** What is wrong, if it is not a parameter: a file, a quantity. */
  readonly subject: string;
  readonly message: readonly Part[];
  readonly hint: readonly Part[];
  /** A valid value of the parameter. */
  readonly suggestion: string;
}

export const NO_ERROR: QueryError = { text: "", parameters: [], item: "", subject: "", message: [], hint: [], suggestion: "" };

/** An error of the page itself. */
export function plainError(text: string): QueryError {
  return { ...NO_ERROR, text, message: [text] };
}

/** The result of a query. */
export interface Answer {
  /** The exit status of the command: 0 success, 1 no result, 2 usage error, 130 cancelled. */
  readonly status: number;
  /** The output of the command. */
  readonly output: Uint8Array;
  readonly error: QueryError;
  /** Written files, by their names in the query. */
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/** A query with its files and callbacks. */
export interface Question {
  /** The command line after `libration`. */
  readonly words: readonly string[];
  /** Files that the words name. The file `-` is the standard input. */
  readonly files?: ReadonlyMap<string, Uint8Array>;
  /** Receives parts of the output as they are written. */
  readonly onOutput?: (chunk: Uint8Array) => void;
  /** Receives the notes of the command, without `note:`. */
  readonly onNote?: (line: string) => void;
  /** Receives the progress of long work, and `undefined` at its end. */
  readonly onProgress?: (howFar: string | undefined) => void;
  /** Cancels the query: the result has status 130, and as its output the partial results that the command writes when it is interrupted; if the
      browser's worker receives no messages while it computes, or after a time limit, what `onOutput` has received until then. */
  readonly signal?: AbortSignal;
}

/** The executor of queries, one after the other. */
export interface Engine {
  ask(question: Question): Promise<Answer>;
  /** A worker with the module, for long work in parallel with the queries; the caller terminates it. */
  worker(): Promise<Worker>;
}

const decoder = new TextDecoder();

/** The output as text. */
export function text(answer: Answer): string {
  return decoder.decode(answer.output);
}
