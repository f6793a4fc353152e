//! Formulas about a few harmonics under a truncated force.

use super::super::formula::Name;
use libration::algebra::Rational;

/// A formula about a few harmonics under a truncated force.
#[derive(Clone, Debug, PartialEq)]
pub struct TruncatedFormula {
    /// The factors of u, u², … in the restoring force divided by ω0², up to the last power that is kept.
    pub force: Vec<Rational>,
    /// The harmonics that are kept.
    pub harmonics: Vec<usize>,
    /// Statement of the formula.
    pub claim: TruncatedClaim,
}

/// The statement of a formula about a few harmonics.
#[derive(Clone, Debug, PartialEq)]
pub enum TruncatedClaim {
    /// The factor of a cosine that must vanish, up to a constant factor.
    Condition {
        /// Number of the harmonic of the cosine.
        harmonic: usize,
        /// `true` if the factor was divided by the first harmonic.
        over_first: bool,
    },
    /// The square of the frequency from the first condition.
    SquaredRatio,
    /// The second condition after substitution of the frequency from the first, up to a constant factor.
    Eliminated,
    /// The second condition, after this substitution, at zero amplitude.
    AtZero,
    /// A harmonic as a series in the amplitude, for substitution into the eliminated condition.
    Series {
        /// The amplitude.
        amplitude: Name,
        /// The harmonic.
        harmonic: usize,
    },
}
