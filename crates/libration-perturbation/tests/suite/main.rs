//! The evidence for perturbation series: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

// Tests read as users of the crate `libration` write.
extern crate libration_perturbation as libration;

mod constants;
mod coupled_slow_flow;
mod exact;
mod expansions;
mod leading_cycles;
mod mirrored;
mod open_gauge;
mod orbit_series;
mod period_majorants;
mod remainders;
mod scaling_law;
mod series_evaluation;
mod slow_decay;
mod slow_flow;
mod symbolic_expansions;
mod symbolic_slow_flow;
mod symbolic_steady_states;
mod truncated_system;
mod two_sided;
mod typed;
mod unit;
