//! Oscillators whose parameters either have values or stay symbols.

use super::{Oscillator, OscillatorError, Remedy, SymbolicOscillator, SymbolicOscillatorError};
use libration_numbers::expression::{Equation, Expression};

/// An oscillator whose parameters have values, or one with symbolic parameters.
#[derive(Clone, Debug)]
pub enum NumbersOrLetters {
    /// Every parameter has a value.
    Numbers(Oscillator),
    /// Some parameters have no value.
    Letters(SymbolicOscillator),
}

impl From<&Oscillator> for NumbersOrLetters {
    fn from(oscillator: &Oscillator) -> Self {
        Self::Numbers(oscillator.clone())
    }
}

impl From<&SymbolicOscillator> for NumbersOrLetters {
    fn from(oscillator: &SymbolicOscillator) -> Self {
        Self::Letters(oscillator.clone())
    }
}

/// The reason why an equation is not an oscillator, with numbers or with symbolic parameters.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NumbersOrLettersError {
    /// The reason with numbers.
    #[error(transparent)]
    Numbers(#[from] OscillatorError),
    /// The reason with symbolic parameters.
    #[error(transparent)]
    Letters(#[from] SymbolicOscillatorError),
}

impl NumbersOrLettersError {
    /// The computations that have a result for such an equation.
    #[must_use]
    pub fn remedies(&self) -> Vec<Remedy> {
        match self {
            Self::Numbers(error) => error.remedies(),
            Self::Letters(_) => vec![],
        }
    }
}

impl NumbersOrLetters {
    /// The oscillator about a position, or about the stable equilibrium nearest to zero; parameters
    /// without a value stay symbols, unless the parameter is the strength of a self-excitation.
    ///
    /// # Errors
    /// The errors of an oscillator with numbers; if only values are missing, those of an oscillator with symbols.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::oscillator::NumbersOrLetters;
    /// let of = |text: &str| NumbersOrLetters::new(&text.parse().unwrap(), None);
    /// assert!(matches!(of("x'' + 2*x + x^3 = 0"), Ok(NumbersOrLetters::Numbers(_))));
    /// assert!(matches!(of("x'' + k*x + x^3 = 0"), Ok(NumbersOrLetters::Letters(_))));
    /// assert!(of("x'' - x = 0").is_err());
    /// ```
    pub fn new(equation: &Equation, about: Option<&Expression>) -> Result<Self, NumbersOrLettersError> {
        let numbers = match about {
            None => Oscillator::new(equation),
            Some(centre) => Oscillator::about(equation, centre),
        };
        let numbers = match numbers {
            Ok(oscillator) => return Ok(Self::Numbers(oscillator)),
            Err(error) if equation.parameters().is_empty() => return Err(error.into()),
            Err(error) => error,
        };
        let letters = match about {
            None => SymbolicOscillator::new(equation),
            Some(centre) => SymbolicOscillator::about(equation, centre),
        };
        match (letters, numbers) {
            (Ok(oscillator), _) => Ok(Self::Letters(oscillator)),
            (Err(error), OscillatorError::WithoutValue { .. }) => Err(error.into()),
            (Err(_), error) => Err(error.into()),
        }
    }
}
