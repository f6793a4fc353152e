//! The evidence for the library: golden tables, published numbers, identities and the map of its modules.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

mod golden;
mod hidden_forces;
mod promises;
mod random;
mod synthetic_trace;
mod ulp;

mod accuracy;
mod architecture;
mod boundaries;
mod chaos;
mod checkpoints;
mod decay;
mod elliptic;
mod equation;
mod events;
mod exact;
mod expansions;
mod expression;
mod fit;
mod fit_budget;
mod fit_cycles;
mod fit_gates;
mod fit_lengths;
mod fitted_pivot;
mod fourier;
mod ledger;
mod malformed;
mod measurement;
mod motion;
mod normal_modes;
mod open_gauge;
mod orbit;
mod period;
mod period_formulas;
mod quantity;
mod recording;
mod rounded_times;
mod series;
mod series_evaluation;
mod systems;
mod taylor;
mod trace_fits;
mod truncated_system;
