//! Motion in time of any system of equations of motion, by its Taylor series.
//!
//! The series of all coordinates come from the tape of the accelerations, one power of the time after the other. Each
//! step is a polynomial that gives the state at every time inside it.

mod error;
mod event;
mod system;
mod tangent;

mod moduli;
mod sign_change;

mod block;
mod ends;
mod program;
mod solution;
mod trajectory;

mod boundary;
mod checkpoint;

mod expander;
mod owned_step;
mod step;
mod step_length;

mod branches;
mod contacts;
mod sharp;
mod steep;
mod sticking;

mod look_ahead;
mod stepper;
mod trial;

mod batch;
mod partial_solution;

mod accepted_step;
mod integrate;

#[cfg(test)]
mod tests;

pub use accepted_step::{AcceptedStep, Start, integrate_from};
pub use checkpoint::{Checkpoint, EventCheckpoint, ModulusCheckpoint};
pub use error::{Cause, IntegrationError};
pub use event::{Contact, Direction, Event, Occurrence};
pub use integrate::{integrate, integrate_many};
pub use owned_step::OwnedStep;
pub use solution::{Moment, Solution};
pub use step::Step;
pub use step_length::Effort;
pub use system::System;
pub use tangent::{with_sensitivities, with_tangents};
pub use trajectory::Trajectory;
