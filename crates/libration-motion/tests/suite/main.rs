//! Tests of motion in time: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

// Tests use the paths of the crate `libration`.
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
mod jumping_forces;
mod orbit;
mod passages;
mod sensitivities;
mod state_errors;
mod systems;
mod taylor;
mod tolerances;
mod typed;
mod unit;
