//! The reasons why there is no such model, or why it has no energy.

use libration_numbers::catalogue::UnknownKey;
use libration_numbers::expression::{EquationError, SecondOrderError, Symbol, WithoutValue};

/// The reason why there is no such model.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A key of neither a system nor an oscillator.
    #[error("{system}; the keys of oscillators are {}", oscillators.join(", "))]
    Unknown {
        /// The unknown key with the keys of the systems.
        system: Box<UnknownKey>,
        /// The keys of all oscillators.
        oscillators: Vec<String>,
    },
    /// A power of the velocity that grows without bound at rest.
    #[error("n = {value} is not a power of a velocity: give a number of 0 or more")]
    NegativePower {
        /// The power.
        value: String,
    },
    /// A power that is not an integer, of a velocity that has either sign.
    #[error(
        "n = {value} is not a whole number, and a velocity below zero has no such power: give a whole number, or use damped_pendulum, which has \
         powers of the magnitude of the velocity"
    )]
    NotWhole {
        /// The power.
        value: String,
    },
    /// A number of bodies that is not an integer in the allowed range.
    #[error("{name} = {value} is not a number of bodies: give a whole number from 1 to {most}")]
    NotACount {
        /// The parameter.
        name: &'static str,
        /// The given value.
        value: String,
        /// The maximum.
        most: u32,
    },
    /// Equations or values that could not be parsed.
    #[error(transparent)]
    Equation(#[from] EquationError),
}

/// The reason why a model has no conserved energy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EnergyError {
    /// Damping or driving.
    #[error("energy is not conserved: it changes by {power} per time")]
    NotConserved {
        /// The energy gained per unit of time.
        power: String,
    },
    /// A force that depends on velocities or the time.
    #[error(
        "the force on {coordinate} depends on {on}: an energy is found only for forces that depend on the coordinates alone"
    )]
    NotOfPlace {
        /// The coordinate.
        coordinate: String,
        /// The velocity, or the time.
        on: Symbol,
    },
    /// Forces with a curl.
    #[error(
        "no potential of the forces could be proved: that on {first} changes with {second} differently from that on {second} with {first}"
    )]
    Curl {
        /// One coordinate.
        first: String,
        /// The other coordinate.
        second: String,
    },
    /// A parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// An equation of first order.
    #[error("the equation for {variable}' is of the first order: an energy is found only for equations of the second order", variable = .0.variable)]
    NotSecondOrder(#[from] SecondOrderError),
}
