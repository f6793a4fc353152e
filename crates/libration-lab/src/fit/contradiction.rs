//! Estimates of T0 that contradict each other, which refute the model they share.

use std::fmt;

use super::significance::{SIGNIFICANT, combined_degrees_of_freedom, limit_of_chance};
use super::uncertain::Uncertain;
use libration::quantity::rounded;

/// Difference, in standard uncertainties of a normal error, above which estimates contradict each other.
const CONTRADICTS: f64 = 2.0;

/// An estimate of T0 with its name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Estimate {
    pub(super) name: String,
    pub(super) t0: Uncertain,
    /// Degrees of freedom of its uncertainty.
    pub(super) degrees_of_freedom: f64,
}

/// Two estimates of T0 from the same data that contradict each other: of all such pairs the one with the largest difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Contradiction {
    /// The estimates, by their names.
    pub between: [String; 2],
    /// Values of T0 of the two estimates, in s.
    pub values: [f64; 2],
    /// Their difference in standard uncertainties.
    pub deviation: f64,
    /// Degrees of freedom of the standard uncertainties; infinite if they are known.
    pub degrees_of_freedom: f64,
}

impl Contradiction {
    /// The half-width of the rectangular distribution that the difference adds to T0, in s.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        (self.values[0] - self.values[1]).abs()
    }

    /// The standard uncertainty of T0 that the model is responsible for, in s (Guide to the Expression of Uncertainty in Measurement, 4.3.7).
    #[must_use]
    pub fn uncertainty(&self) -> f64 {
        self.half_width() / 3.0_f64.sqrt()
    }

    /// Returns `true` if the difference is beyond chance, so that the model is refuted.
    #[must_use]
    pub fn refutes(&self) -> bool {
        self.deviation > limit_of_chance(SIGNIFICANT, self.degrees_of_freedom)
    }

    /// Returns the contradiction of two estimates that differ by this many standard uncertainties, found with these degrees of freedom; `None` where
    /// they agree.
    pub(super) fn of(pair: [&Estimate; 2], deviation: f64, degrees_of_freedom: f64) -> Option<Self> {
        let between = pair.map(|estimate| estimate.name.clone());
        let values = pair.map(|estimate| estimate.t0.value);
        let limit = limit_of_chance(CONTRADICTS, degrees_of_freedom);
        (deviation > limit).then_some(Self { between, values, deviation, degrees_of_freedom })
    }

    /// Returns the contradiction of two estimates with independent errors.
    pub(super) fn of_independent(pair: [&Estimate; 2]) -> Option<Self> {
        let [one, other] = pair.map(|estimate| estimate.t0);
        let errors = pair.map(|estimate| (estimate.t0.uncertainty, estimate.degrees_of_freedom));
        let deviation = one.with_error(other.uncertainty).deviation_from(other.value);
        Self::of(pair, deviation, combined_degrees_of_freedom(&errors))
    }

    /// Returns the contradiction with the largest difference.
    pub(super) fn largest(contradictions: impl Iterator<Item = Self>) -> Option<Self> {
        contradictions.max_by(|a, b| a.half_width().total_cmp(&b.half_width()))
    }
}

/// The contradiction in words, with the number of standard uncertainties.
impl fmt::Display for Contradiction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [[one, other], values] = [&self.between, &self.values.map(|value| rounded(value, 7))];
        write!(
            f,
            "T₀ is {} s with {one} and {} s with {other}, {} standard uncertainties apart",
            values[0],
            values[1],
            rounded(self.deviation, 2)
        )
    }
}
