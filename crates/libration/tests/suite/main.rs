//! The evidence for the library: golden tables, published numbers, identities and the map of its modules.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

mod condition;
mod continuation;
mod forced_references;
mod golden;
mod hidden_forces;
mod period_majorants;
mod precise_special_points;
mod promises;
mod random;
mod remainders;
mod rotations;
mod scaling_law;
mod two_sided;
mod ulp;

mod accuracy;
mod boundaries;
mod chaos;
mod checkpoints;
mod coming_to_rest;
mod conservative;
mod crossings;
mod decay;
mod elliptic;
mod elliptic_batches;
mod ensemble;
mod equation;
mod events;
mod exact;
mod expansions;
mod expression;
mod first_order;
mod fourier;
mod leading_cycles;
mod ledger;
mod melnikov;
mod mirrored;
mod motion;
mod nonlinear_modes;
mod normal_form;
mod normal_modes;
mod open_gauge;
mod orbit;
mod orders;
mod passages;
mod pendulum_chain;
mod period;
mod period_formulas;
mod quantity;
mod self_excited_branches;
mod sensitivities;
#[cfg(feature = "serde")]
mod serialize;
mod series;
mod series_evaluation;
mod slow_decay;
mod slow_flow;
mod stability_charts;
mod symbolic_expansions;
mod systems;
mod taylor;
mod tolerances;
mod truncated_system;
mod watch;
