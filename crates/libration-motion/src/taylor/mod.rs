//! Motion in time of any system of equations of motion, by its Taylor series.
//!
//! The series of all coordinates come from the tape of the accelerations, one power of the time after the other. Each
//! step is a polynomial that gives the state at every time inside it.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::progress::Quiet;
//! use libration::taylor::{Effort, Event, System, integrate, integrate_dense};
//!
//! // A damped pendulum from 2 rad: the states at two times, and the times at which it passes the bottom.
//! let bottom = Event::zero_of("theta".parse()?);
//! let system = System::new(&"theta'' + theta'/10 + sin(theta) = 0".parse()?)?.with_events(&[bottom])?;
//! let start = system.start(&[("theta", 2.0)])?;
//! let solution = integrate(&system, &start, &[5.0, 10.0], &Effort::to_tolerance(1e-15), &Quiet)?;
//! assert_eq!((solution.samples.len(), solution.events.len()), (2, 3));
//!
//! // The same motion at every time.
//! let motion = integrate_dense(&system, &start, 10.0, &Effort::to_tolerance(1e-15))?;
//! assert_eq!(motion.state_at(5.0).as_ref(), Some(&solution.samples[0].state));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! The tape of the accelerations is translated to a program: instructions on one block of series, from which all computations are removed that
//! are the same at every order (`program/program.rs`). The recurrences are those of `series`, over a ring of N independent `f64`s. One motion is
//! the case N = 1; many motions are computed in lanes, each with its own steps (`drivers/batch.rs`), and as every operation is done lane by lane
//! the bits are the same. Sixteen motions are computed side by side, two registers of AVX-512, so that neither waits for the other. The
//! conditions on a step (convergence of the series, singularities and events inside it, agreement of its end with the equations) are evaluated
//! for all lanes at once, or for several state components of one motion at once.
//!
//! Sums of products are formed from the middle to the ends, which contain the newest coefficients, so that a processor has
//! computed all other terms before these are known. Products, quotients and integrals of one order have the same number of
//! terms in the middle, so that machine code can compute these side by side. From the eighth order on quotients by constants
//! are products with a reciprocal. A step ends at an `f64` time; states are carried in two words from step to step.
//!
//! An absolute value |u| is on the tape as s·u and sign(u) as s, with an input s = ±1; a step ends where u changes its
//! sign, found on the Bernstein form of its polynomial, so that no change is missed (`nonsmooth/branches.rs`). u/|u|^p
//! is replaced by |u|^(1−p)·sign(u) (`program/quotients.rs`). A step next to such a power, or one that no radius of
//! convergence limits, is no longer than the rounding errors of cancelling terms allow (`drivers/cancellation.rs`).

mod error;
mod solution;
mod bounds;
mod drivers;
mod events;
mod nonsmooth;
pub(crate) mod program;
pub(crate) mod step;

pub use bounds::ending::ending_error;
pub use bounds::event_errors::MomentErrors;
pub use bounds::sampled_errors::SampledErrors;
pub use bounds::state_errors::StateErrors;
pub use drivers::accepted_step::{AcceptedStep, Start, integrate_from};
pub use drivers::both_ways::integrate_both_ways;
pub use drivers::checkpoint::{Checkpoint, EventCheckpoint, ModulusCheckpoint};
pub use drivers::dense_solution::{DenseSolution, integrate_dense};
pub use drivers::ensemble::Ensemble;
pub use drivers::gradients::Gradients;
pub use drivers::integrate::{integrate, integrate_many, integrate_many_stepwise, integrate_stepwise};
pub use drivers::owned_step::OwnedStep;
pub use drivers::sensitivities::{Sensitivities, SensitivityError};
pub use drivers::trajectory::Trajectory;
pub use error::{Cause, IntegrationError, NoDerivative};
pub use events::event::{Contact, Direction, Event, Occurrence};
pub use program::state_names::StateNameError;
pub use program::system::System;
pub use program::tangent::{with_sensitivities, with_tangents};
pub use solution::{Moment, Solution};
pub use step::Step;
pub use step::layout::StateLayout;
pub use step::step_length::Effort;
pub use step::tolerances::ToleranceError;

use drivers::integrate::LANES;

pub(crate) use drivers::phases::{Approach, NEAR_ZERO, Phase, Side, phases};
pub(crate) use program::open_signs::OpenSigns;
pub(crate) use program::state_names::named_state;
pub(crate) use step::larger::larger_or_nan;
