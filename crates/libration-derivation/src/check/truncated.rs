//! Formulas about a few harmonics under a force that is cut off.

use super::super::formula::Name;
use libration::algebra::Rational;

/// A formula about a few harmonics under a force that is cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct TruncatedFormula {
    /// The factors of u, u², … in the restoring force over ω0², to the last power that is kept.
    pub force: Vec<Rational>,
    /// The harmonics that are kept.
    pub harmonics: Vec<usize>,
    /// Statement of the formula.
    pub claim: TruncatedClaim,
}

/// The statement of a formula about a few harmonics.
#[derive(Clone, Debug, PartialEq)]
pub enum TruncatedClaim {
    /// The factor of a cosine that must vanish, up to a number.
    Condition {
        /// Number of the harmonic of that cosine.
        harmonic: usize,
        /// `true` if it was divided by the first harmonic.
        over_first: bool,
    },
    /// The square of the frequency by the first condition.
    SquaredRatio,
    /// The second condition with that, up to a number.
    Eliminated,
    /// The same where the amplitude is zero.
    AtZero,
    /// A harmonic as a series in the amplitude, to be put into the eliminated condition.
    Series {
        /// The amplitude.
        amplitude: Name,
        /// The harmonic.
        harmonic: usize,
    },
}
