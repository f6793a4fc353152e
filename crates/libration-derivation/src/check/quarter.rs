//! Formulas of a quarter swing under a force with two sides, power by power of the amplitude.

use super::super::formula::{Formula, Name};
use libration::algebra::Rational;

/// A formula of a quarter swing, and its force.
#[derive(Clone, Debug, PartialEq)]
pub struct QuarterFormula {
    /// The factors of u², u³, … in the restoring force over ω0².
    pub force: Vec<Rational>,
    /// The power of the amplitude.
    pub power: usize,
    /// Statement of the formula.
    pub claim: QuarterClaim,
}

/// The statement of a formula of a quarter swing.
#[derive(Clone, Debug, PartialEq)]
pub enum QuarterClaim {
    /// The right side that lower powers lead to.
    Forcing {
        /// The right side without the correction of the frequency.
        value: Formula,
    },
    /// The solution for this right side that begins at rest in zero.
    Begun,
    /// The correction of the frequency, with which the displacement vanishes at the end.
    Correction,
    /// The motion.
    Motion,
    /// A harmonic as a series in the amplitude.
    Harmonic {
        /// The amplitude.
        amplitude: Name,
        /// Number of the harmonic.
        harmonic: usize,
    },
}
