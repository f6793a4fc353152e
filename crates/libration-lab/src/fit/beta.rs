//! The one-parameter test of a law: T = T0·[1 + β(R(A) − 1)], where β = 1 is the law itself.

use nalgebra::{DMatrix, DVector};

use super::significance::{SIGNIFICANT, combined_degrees_of_freedom, limit_of_chance};
use super::uncertain::Uncertain;

/// β with the period of small swings that was fitted with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beta {
    /// β, the factor on the law's excess R − 1: 1 is the law, 0 a constant period.
    pub factor: Uncertain,
    /// The period of small swings, in seconds.
    pub t0: Uncertain,
    /// Correlation coefficient of T0 and β.
    pub correlation: f64,
    /// Degrees of freedom of the uncertainties: of the scatter of the rows where they come from it, otherwise infinite.
    pub degrees_of_freedom: f64,
}

impl Beta {
    /// Computes β from the line T = T0 + (T0β)·(R − 1): its two coefficients, with their covariance.
    #[doc(hidden)]
    pub fn from_line(
        coefficients: &DVector<f64>,
        covariance: &DMatrix<f64>,
        degrees_of_freedom: f64,
    ) -> Self {
        let [t0, slope] = [coefficients[0], coefficients[1]];
        let [of_t0, both, of_slope] = [covariance[(0, 0)], covariance[(0, 1)], covariance[(1, 1)]];
        let beta = slope / t0;
        let variance = (of_slope - 2.0 * beta * both + beta * beta * of_t0) / (t0 * t0);
        Self {
            factor: Uncertain { value: beta, uncertainty: variance.sqrt() },
            t0: Uncertain { value: t0, uncertainty: of_t0.sqrt() },
            correlation: (both - beta * of_t0) / t0 / (of_t0 * variance).sqrt(),
            degrees_of_freedom,
        }
    }

    /// Adds an independent error, which changes both values to those of `moved`.
    #[doc(hidden)]
    pub fn with_error(self, moved: &Self) -> Self {
        let [of_t0, of_beta] = [moved.t0.value - self.t0.value, moved.factor.value - self.factor.value];
        let (factor, t0) = (self.factor.with_error(of_beta), self.t0.with_error(of_t0));
        let both = self.correlation * self.t0.uncertainty * self.factor.uncertainty + of_t0 * of_beta;
        let correlation = both / (t0.uncertainty * factor.uncertainty);
        Self { t0, correlation, ..self.with_factor(factor) }
    }

    /// The β after multiplication by a factor of known uncertainty.
    pub(super) fn with_factor(self, factor: Uncertain) -> Self {
        let [scatter, all] = [self.factor, factor].map(|value| value.uncertainty);
        let spread = (all * all - scatter * scatter).max(0.0).sqrt();
        let errors = [(scatter, self.degrees_of_freedom), (spread, f64::INFINITY)];
        Self { factor, degrees_of_freedom: combined_degrees_of_freedom(&errors), ..self }
    }

    /// Distance of β from that of the exact law, in standard uncertainties.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.factor.deviation_from(1.0)
    }

    /// Returns `true` if that distance is more than chance: [`SIGNIFICANT`] standard uncertainties, or as improbable a distance by Student's
    /// distribution.
    #[must_use]
    pub fn differs_from_one(&self) -> bool {
        self.deviation() > limit_of_chance(SIGNIFICANT, self.degrees_of_freedom)
    }

    /// Relative error of the angles (positive where they are too small), if a wrong scale is why β is not 1, since R − 1 goes with the square of the
    /// amplitude; `None` above a fifth, which no camera, protractor or gyroscope is wrong by.
    #[must_use]
    pub fn scale_error(&self) -> Option<f64> {
        const MOST: f64 = 0.2;
        Some(0.5 * (self.factor.value - 1.0)).filter(|part| part.abs() < MOST)
    }
}
