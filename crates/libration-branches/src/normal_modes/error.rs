//! Errors of the search for normal modes.

use libration_numbers::expression::{Equation, SecondOrderError, WithoutValue};
use libration_numbers::progress::Interrupted;

/// Reason why a system has no normal modes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModesError {
    /// A symbolic parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// An equation of first order.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// Accelerations that depend on the time.
    #[error("the accelerations depend on the time t: set the strength of the driving to zero")]
    DependsOnTime,
    /// A guess of the wrong length.
    #[error("the guess {guess:?} does not fit: give a finite number for each of {wanted} coordinates")]
    Guess {
        /// The given guess.
        guess: Vec<f64>,
        /// The number of coordinates.
        wanted: usize,
    },
    /// A guess from which no equilibrium was reached.
    #[error(
        "no equilibrium was found from {from}: the search came to {to}, {end}; if there is one, give a guess nearer to it"
    )]
    NoEquilibrium {
        /// The guess.
        from: Position,
        /// The last point of Newton's method.
        to: Position,
        /// The reason why the method ended at this point.
        end: SearchEnd,
    },
    /// Accelerations without derivatives.
    #[error(
        "at the equilibrium {at} the accelerations or their derivatives have no value, jump, or are beyond the range of numbers, so that small motions are \
         not linear there: choose another equilibrium, or other coordinates"
    )]
    NotSmooth {
        /// The equilibrium.
        at: Position,
    },
    /// Eigenvalues that do not converge.
    #[error("the frequencies are not found: the eigenvalues of the linear equations do not converge")]
    NoEigenvalues,
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// The coordinates of a system with their names, written as `x = 1, y = 0.5`.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// The names of the coordinates.
    pub names: Vec<String>,
    /// The values, one for each name.
    pub values: Vec<f64>,
}

impl Position {
    pub(super) fn new(equation: &Equation, values: &[f64]) -> Self {
        Self {
            names: equation.variables().iter().map(ToString::to_string).collect(),
            values: values.to_vec(),
        }
    }
}

impl std::fmt::Display for Position {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, (name, value)) in self.names.iter().zip(&self.values).enumerate() {
            let separator = if i == 0 { "" } else { ", " };
            let digits = format!("{value:?}");
            write!(f, "{separator}{name} = {}", digits.strip_suffix(".0").unwrap_or(&digits))?;
        }
        Ok(())
    }
}

/// Reason why the search for an equilibrium ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SearchEnd {
    /// The accelerations have no finite value.
    #[error("where the accelerations at rest have no finite value")]
    NoValue,
    /// The Jacobian matrix does not lead to a zero.
    #[error("where they are not zero and their slopes do not lead to a zero")]
    NoSlope,
    /// The accelerations vanish up to rounding errors, but no simple zero is there.
    #[error(
        "where they vanish up to rounding errors, but have no simple zero: they approach zero, touch it, or have a multiple zero"
    )]
    Rounding,
    /// The step limit was reached.
    #[error("where it stopped without convergence")]
    Unsettled,
}
