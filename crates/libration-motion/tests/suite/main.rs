//! The evidence for motion in time: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

// Tests read as users of the crate `libration` write.
extern crate libration_motion as libration;

mod boundaries;
mod chaos;
mod checkpoints;
mod coming_to_rest;
mod conservative;
mod decay;
mod endings;
mod ensemble;
mod events;
mod hidden_forces;
mod orbit;
mod passages;
mod sensitivities;
mod state_errors;
mod systems;
mod taylor;
mod tolerances;
mod typed;
mod unit;
