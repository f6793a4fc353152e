//! Evidence for branches and modes: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

// Tests are written as users of the crate `libration` would write them.
extern crate libration_branches as libration;

mod brute_force;
mod continuation;
mod crossings;
mod equivalent_forms;
mod first_order;
mod forced_references;
mod melnikov;
mod nonlinear_modes;
mod normal_form;
mod normal_modes;
mod orders;
mod pendulum_chain;
mod precise_special_points;
mod rotations;
mod self_excited_branches;
mod small_scales;
mod stability_charts;
mod typed;
mod unit;
