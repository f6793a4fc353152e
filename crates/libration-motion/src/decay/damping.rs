//! Damping of the pendulum: sums of powers of the velocity.

use super::DecayError;
use libration_numbers::internals::algebra::InOrder;

/// The damping c·θ′|θ′|ⁿ⁻¹.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLawTerm {
    /// n, zero or more: 0 is dry friction, 1 is viscous damping, 2 the drag in a fast flow.
    pub exponent: f64,
    /// c in radⁿ⁻¹… per unit of mass and length: rad/s² for n = 0, 1/s for n = 1, 1/rad for n = 2, s/rad² for n = 3.
    pub coefficient: f64,
}

/// A sum of powers of the velocity with different exponents and positive coefficients, the lowest exponent first.
#[derive(Clone, Debug, PartialEq)]
pub struct Damping {
    terms: Vec<PowerLawTerm>,
}

impl Damping {
    /// Maximum number of different powers.
    pub const MOST_TERMS: usize = super::error::MOST_TERMS;

    /// The sum of these terms; terms with equal powers are added.
    ///
    /// # Errors
    /// A negative power, a negative coefficient, numbers that are not finite, no positive coefficient, or too many powers.
    pub fn new(terms: &[PowerLawTerm]) -> Result<Self, DecayError> {
        let mut sums: Vec<PowerLawTerm> = vec![];
        for &PowerLawTerm { exponent, coefficient } in terms {
            if !(0.0..f64::INFINITY).contains(&exponent) {
                return Err(DecayError::Exponent(exponent));
            }
            if !(0.0..f64::INFINITY).contains(&coefficient) {
                return Err(DecayError::Coefficient { coefficient, exponent });
            }
            match sums.iter_mut().find(|sum| sum.exponent.total_cmp(&exponent).is_eq()) {
                Some(sum) => sum.coefficient += coefficient,
                None => sums.push(PowerLawTerm { exponent, coefficient }),
            }
        }
        if sums.len() > Self::MOST_TERMS {
            return Err(DecayError::TooManyTerms(sums.len()));
        }
        sums.retain(|term| term.coefficient > 0.0);
        sums.put_in_order(|a, b| a.exponent.total_cmp(&b.exponent));
        if sums.is_empty() { Err(DecayError::NoDamping) } else { Ok(Self { terms: sums }) }
    }

    /// A single power of the velocity.
    ///
    /// # Errors
    /// As for [`Damping::new`].
    pub fn of_degree(exponent: f64, coefficient: f64) -> Result<Self, DecayError> {
        Self::new(&[PowerLawTerm { exponent, coefficient }])
    }

    /// The terms, the lowest power first.
    #[must_use]
    pub fn terms(&self) -> &[PowerLawTerm] {
        &self.terms
    }

    /// The coefficient of a power; zero if the power does not occur.
    pub(super) fn coefficient_of(&self, exponent: f64) -> f64 {
        let of_power = self.terms.iter().find(|term| term.exponent.total_cmp(&exponent).is_eq());
        of_power.map_or(0.0, |term| term.coefficient)
    }

    /// The deceleration at a nonnegative velocity.
    pub(super) fn at(&self, velocity: f64) -> f64 {
        self.terms.iter().map(|term| term.coefficient * libm::pow(velocity, term.exponent)).sum()
    }

    /// Returns `true` if the damping is analytic in the velocity on each side of zero, that is, if all powers are integers.
    pub(super) fn is_analytic(&self) -> bool {
        self.terms.iter().all(|term| term.exponent.fract() == 0.0)
    }

    /// The damping in units of time 1/ω0: cₙ ω0ⁿ⁻².
    pub(super) fn scaled(&self, angular_frequency: f64) -> Result<Self, DecayError> {
        let scaled = |term: &PowerLawTerm| {
            let exponent = term.exponent;
            let value = term.coefficient * libm::pow(angular_frequency, exponent - 2.0);
            let usable = value.is_normal();
            usable
                .then_some(PowerLawTerm { exponent, coefficient: value })
                .ok_or(DecayError::OutOfRange { exponent, value })
        };
        Ok(Self { terms: self.terms.iter().map(scaled).collect::<Result<_, _>>()? })
    }
}
