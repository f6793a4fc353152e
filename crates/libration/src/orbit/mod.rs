//! Periodic orbits of any equations of motion, found by integration in time.
//!
//! The motion of one coordinate that is released from rest is followed until it comes to rest again. Limit cycles, answers to a
//! periodic force, and orbits of several coordinates are closed by Newton's method, whose derivatives come from the
//! equations of small deviations; these also tell the Floquet multipliers.

mod error;

mod path;

mod harmonics;
mod near;
mod periodic;

mod floquet;

mod acceleration;
mod place;
mod precise;
mod released;

mod closing;
mod shooting;

mod cycle;
mod driven;

pub use error::{Lost, NoOrbit};
pub use floquet::{Floquet, Stability};
pub use harmonics::{Harmonic, Harmonics};
pub use near::Near;
pub use periodic::Orbit;
pub(crate) use place::Place;
