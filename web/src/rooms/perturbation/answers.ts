// The results of the command for expansions, as JSON.

export interface Oscillators {
  readonly oscillators: readonly { key: string; title: string; equation: string; parameters: readonly { name: string; default: string }[] }[];
}

/** The result of `libration expand --evaluate`. */
export interface Evaluation {
  readonly amplitude: number;
  readonly exact: number | null;
  readonly exact_uncertainty: number | null;
  readonly exact_by: string | null;
  readonly radius: number | null;
  readonly radius_is: string | null;
  readonly smallest_term_power: number | null;
  readonly steps: readonly { power: number; coefficient: string; term: number; sum: number; error: number | null; bound: number | null; bound_is: string | null }[];
}

/** The result of `libration backbone`. */
export interface Backbone {
  readonly points: readonly {
    amplitude: number;
    angular_frequency_rad_per_s: number | null;
    angular_frequency_uncertainty_rad_per_s: number | null;
    series_angular_frequency_rad_per_s: number | null;
    exact?: number | null;
  }[];
}
