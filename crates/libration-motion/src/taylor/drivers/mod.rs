//! Integrations of one or many motions, step after step.

pub(super) mod accepted_step;
pub(super) mod batch;
pub(super) mod both_ways;
pub(super) mod cancellation;
pub(super) mod checkpoint;
pub(super) mod dense_solution;
pub(super) mod ensemble;
pub(super) mod gradients;
pub(super) mod integrate;
pub(super) mod look_ahead;
pub(super) mod owned_step;
pub(super) mod partial_solution;
pub(super) mod passing;
pub(crate) mod phases;
pub(super) mod rest;
pub(super) mod sensitivities;
pub(super) mod stepper;
pub(super) mod trajectory;
pub(super) mod trial;
