// The data of the command about the formulas for the period.

/** An entry of `libration formulas`. */
export interface Formula {
  readonly key: string;
  readonly name: string;
  /** The series or iteration that it is a member of, or its key. */
  readonly family: string;
  readonly authors: string;
  readonly year: number | null;
  readonly source: string;
  readonly latex: string;
  readonly domain: string;
  readonly complexity: number;
  /** The largest magnitude of the error up to 90°; `null` if the formula ends before. */
  readonly worst_error_to_90deg: number | null;
  /** With a tolerance: the amplitude up to which the formula is within it; `null` if it always is. */
  readonly holds_to_rad?: number | null;
}

export interface Catalogue {
  readonly formulas: readonly Formula[];
}

export interface Crossovers {
  readonly crossovers: readonly { amplitude_rad: number; better_below: string; better_above: string; error: number }[];
}

/** The result of `libration period`. */
export interface Periods {
  readonly results: readonly {
    readonly amplitude_rad: number;
    readonly ratio: number;
    readonly formulas: readonly { key: string; ratio: number | null; fractional_error: number | null }[];
  }[];
}
