//! Equations of motion as texts, and the systems and oscillators that they state.

use libration::expression::Equation;
use libration::taylor::System;

/// The equation of motion that a text states.
pub(crate) fn equation(text: &str) -> Equation {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The equation of motion that a text states, with values of its parameters.
pub(crate) fn equation_with(text: &str, values: &[(&str, &str)]) -> Equation {
    let values: Vec<_> = values.iter().map(|(name, value)| (*name, value.parse().unwrap())).collect();
    equation(text).with(&values).unwrap()
}

/// The system of the equations of motion that a text states.
pub(crate) fn system(text: &str) -> System {
    System::new(&equation(text)).unwrap()
}
