//! Errors of states, events and ends of a motion.

pub(super) mod crossing;
pub(super) mod ending;
pub(super) mod event_errors;
pub(super) mod exponential;
pub(super) mod gathered;
pub(super) mod growth;
pub(super) mod kept_errors;
pub(super) mod matrix;
pub(super) mod outcome;
pub(super) mod pieces;
pub(super) mod propagator;
pub(super) mod roundings_of_steps;
pub(super) mod sampled_errors;
pub(super) mod spread;
pub(super) mod state_errors;
pub(super) mod survey;
