//! Equations of motion as texts, and the systems and oscillators that they state.

use libration::expression::Equation;
use libration::oscillator::Oscillator;

/// The equation of motion that a text states.
pub(crate) fn equation(text: &str) -> Equation {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The oscillator of the equation that a text states.
pub(crate) fn oscillator(text: &str) -> Oscillator {
    Oscillator::new(&equation(text)).unwrap_or_else(|error| panic!("{text}: {error}"))
}
