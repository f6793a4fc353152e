//! The one-parameter test of a law: T = T0·[1 + β(R(A) − 1)], where β = 1 is the law itself.

use nalgebra::{DMatrix, DVector};

use super::significance::SIGNIFICANT;
use super::uncertain::Uncertain;

/// β, with the period of small swings that goes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beta {
    /// β, the factor on the law's excess R − 1: 1 is the law, 0 a constant period.
    pub factor: Uncertain,
    /// The period of small swings, in seconds.
    pub t0: Uncertain,
    /// Of T0 and β.
    pub correlation: f64,
}

impl Beta {
    /// By the line T = T0 + (T0β)·(R − 1): its two coefficients, with their covariance.
    pub(super) fn from_line(coefficients: &DVector<f64>, covariance: &DMatrix<f64>) -> Self {
        let [t0, slope] = [coefficients[0], coefficients[1]];
        let [of_t0, both, of_slope] = [covariance[(0, 0)], covariance[(0, 1)], covariance[(1, 1)]];
        let beta = slope / t0;
        let variance = (of_slope - 2.0 * beta * both + beta * beta * of_t0) / (t0 * t0);
        Self {
            factor: Uncertain { value: beta, uncertainty: variance.sqrt() },
            t0: Uncertain { value: t0, uncertainty: of_t0.sqrt() },
            correlation: (both - beta * of_t0) / t0 / (of_t0 * variance).sqrt(),
        }
    }

    /// With an independent error more, by what it makes of both.
    pub(super) fn with_error(self, moved: &Self) -> Self {
        let [of_t0, of_beta] = [moved.t0.value - self.t0.value, moved.factor.value - self.factor.value];
        let (factor, t0) = (self.factor.with_error(of_beta), self.t0.with_error(of_t0));
        let both = self.correlation * self.t0.uncertainty * self.factor.uncertainty + of_t0 * of_beta;
        Self { factor, t0, correlation: both / (t0.uncertainty * factor.uncertainty) }
    }

    /// By how many of its uncertainties it differs from that of the exact law.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.factor.deviation_from(1.0)
    }

    /// Whether that is more than chance: [`SIGNIFICANT`].
    #[must_use]
    pub fn differs_from_one(&self) -> bool {
        self.deviation() > SIGNIFICANT
    }

    /// By which part of them the angles are too small, if a wrong scale is why β is not 1, since R − 1 goes with the square of the
    /// amplitude; none above a fifth, which no camera, protractor or gyroscope is wrong by.
    #[must_use]
    pub fn scale_error(&self) -> Option<f64> {
        const MOST: f64 = 0.2;
        Some(0.5 * (self.factor.value - 1.0)).filter(|part| part.abs() < MOST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beta(value: f64, uncertainty: f64) -> Beta {
        let t0 = Uncertain { value: 2.0, uncertainty: 3e-4 };
        Beta { factor: Uncertain { value, uncertainty }, t0, correlation: -0.5 }
    }

    #[test]
    fn three_uncertainties_from_one_are_no_chance() {
        assert!(!beta(1.0299, 0.01).differs_from_one() && beta(1.0301, 0.01).differs_from_one());
        assert!(!beta(0.9701, 0.01).differs_from_one() && beta(0.9699, 0.01).differs_from_one());
    }

    #[test]
    fn a_scale_is_suspected_up_to_a_fifth() {
        assert!((beta(1.2, 0.01).scale_error().unwrap() - 0.1).abs() < 1e-15);
        assert!(beta(1.399, 0.01).scale_error().is_some() && beta(0.601, 0.01).scale_error().is_some());
        assert_eq!([1.401, 0.599].map(|value| beta(value, 0.01).scale_error()), [None, None]);
    }

    /// T0 and T0β without a correlation: β = 1.5 varies by both.
    #[test]
    fn the_quotient_has_the_covariance_of_the_line() {
        let found = Beta::from_line(
            &DVector::from_row_slice(&[2.0, 3.0]),
            &DMatrix::from_row_slice(2, 2, &[4e-6, 0.0, 0.0, 9e-6]),
        );
        let variance: f64 = (9e-6 + 2.25 * 4e-6) / 4.0;
        assert!((found.factor.value - 1.5).abs() < 1e-15);
        assert!((found.factor.uncertainty - variance.sqrt()).abs() < 1e-15);
        let correlation = -1.5 * 4e-6 / 2.0 / (2e-3 * variance.sqrt());
        assert!((found.correlation - correlation).abs() < 1e-12, "{found:?}");
    }

    /// Errors of 4e-4 s and 0.04 that go together: (−0.5·3e-4·0.03 + 4e-4·0.04)/(5e-4·0.05).
    #[test]
    fn an_error_of_both_correlates_them() {
        let before = beta(1.0, 0.03);
        let mut moved = before;
        (moved.t0.value, moved.factor.value) = (2.0004, 1.04);
        let after = before.with_error(&moved);
        assert!(
            (after.t0.uncertainty - 5e-4).abs() < 1e-15 && (after.factor.uncertainty - 0.05).abs() < 1e-15
        );
        assert!((after.correlation - 0.46).abs() < 1e-9, "{after:?}");
    }
}
