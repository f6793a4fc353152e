//! Oscillators: an equation of motion about an equilibrium, and a catalogue of named ones.

mod catalogue;
mod named;

mod centre;
mod constant;
mod equilibrium;
mod force;
mod neighbourhood;
mod roots;

mod error;
mod model;

pub use catalogue::catalogue;
pub use centre::centre_of;
pub use constant::{Approximation, Constant};
pub use error::{Found, OscillatorError, Refusal, Unfit};
pub use model::{Kind, Oscillator};
pub use named::{NamedOscillator, Parameter, UnknownOscillator};
pub use neighbourhood::{Roughness, Tendency};

#[cfg(test)]
mod tests;
