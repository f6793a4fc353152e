// Questions of the command, asked in the page: the same words, and the same bytes as answers.

/** A text, or the mark of a parameter or a query of the command, which has other names on the page. */
export type Part = string | { readonly parameter: string } | { readonly query: string };

/** Why a query has no result; what does not exist is empty. */
export interface QueryError {
  /** In the words of the command; empty where nothing is wrong. */
  readonly text: string;
  /** The parameters that it is about, as `--order` or `OSCILLATOR|EQUATION`. */
  readonly parameters: readonly string[];
  /** The name of the value that it is about, in a parameter that has several. */
  readonly item: string;
  readonly message: readonly Part[];
  readonly hint: readonly Part[];
  /** A value of the parameter that would do. */
  readonly suggestion: string;
}

export const NO_ERROR: QueryError = { text: "", parameters: [], item: "", message: [], hint: [], suggestion: "" };

/** An error of the page itself. */
export function plainError(text: string): QueryError {
  return { ...NO_ERROR, text, message: [text] };
}

/** What the command answers. */
export interface Answer {
  /** As the command's exit status: 0 success, 1 no answer, 2 usage error, 130 ended early. */
  readonly status: number;
  /** What the command writes to its output. */
  readonly output: Uint8Array;
  readonly error: QueryError;
  /** Files that were written, by the names in the question. */
  readonly files: ReadonlyMap<string, Uint8Array>;
}

/** What is asked. */
export interface Question {
  /** The command line behind `libration`. */
  readonly words: readonly string[];
  /** Files that the words name. What is called `-` is the standard input. */
  readonly files?: ReadonlyMap<string, Uint8Array>;
  /** Takes parts of the output as they come. */
  readonly onOutput?: (chunk: Uint8Array) => void;
  /** Takes the sentences that the command says beside its answer, behind `note:`. */
  readonly onNote?: (line: string) => void;
  /** Takes how far long work is, and `undefined` when that work has ended. */
  readonly onProgress?: (howFar: string | undefined) => void;
  /** Ends the question early: the answer has status 130, and what is done as its output, as the command writes it when it is interrupted; where the
      browser's worker hears nothing while it computes, or long after, what `onOutput` has brought until then. */
  readonly signal?: AbortSignal;
}

/** Whoever answers. Questions wait for each other. */
export interface Engine {
  ask(question: Question): Promise<Answer>;
  /** A worker with the module, for long work beside the questions; whoever has asked for it ends it. */
  worker(): Promise<Worker>;
}

const decoder = new TextDecoder();

/** The output as text. */
export function text(answer: Answer): string {
  return decoder.decode(answer.output);
}
