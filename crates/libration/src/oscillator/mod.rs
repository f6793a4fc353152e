//! Oscillators: an equation of motion about an equilibrium, and a catalogue of named ones.

mod catalogue;
mod named;

mod constant;
mod equilibrium;
mod force;
mod neighbourhood;
mod roots;

mod error;
mod model;

mod periodic_motion;

pub use constant::{Approximation, Constant};
pub use error::{Found, OscillatorError, Refusal, Unfit};
pub use model::{Kind, Oscillator};
pub use named::{NamedOscillator, Parameter, UnknownOscillator, catalogue};
pub use neighbourhood::{Roughness, Tendency};
pub use periodic_motion::{NoPeriodicMotion, PeriodicMotion};

#[cfg(test)]
mod tests;
