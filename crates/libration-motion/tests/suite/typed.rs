//! Equations of motion from text, and the systems and oscillators that they define.

use libration::expression::Equation;
use libration::taylor::{Moment, System};

/// The equation of motion that a text defines.
pub(crate) fn equation(text: &str) -> Equation {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The system of the equations of motion that a text defines.
pub(crate) fn system(text: &str) -> System {
    System::new(&equation(text)).unwrap()
}

/// A state at time zero.
pub(crate) fn from(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}
