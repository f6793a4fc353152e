//! The falling amplitude, and the curves of the laws of damping that are fitted to it.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::HalfSwing;
use super::decay_rates::DecayRates;
use crate::fit::falling::falling;
use crate::fit::trace::{DampingKind, DampingModel};
use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
use crate::statistics::{Design, median, robust_deviation, weighted_least_squares};
use libration::internals::progress::Watch;

/// χ² is smooth to rounding errors; the derivatives by differences only slow the search down.
const EFFORT: Effort = Effort { tolerance: 1e-10, patience: 30 };
/// Step of difference quotients, relative to an amplitude or to a coefficient that would halve it: with 1e-4 and 1e-6 nothing changed in seven
/// recordings.
const STEP: f64 = 1e-5;
/// Relative error of difference quotients: rounding over that step, with that of hundreds of integration steps.
const EXACTNESS: f64 = 1e-8;
/// Distance from the curve, in robust standard deviations, above which extremes do not count: among normal errors one in 5e8.
const OUTLIER: f64 = 6.0;

/// The falling amplitude.
pub(super) struct Fall<'a> {
    pub(super) half_swings: &'a [HalfSwing],
    pub(super) rates: DecayRates,
    /// One over the uncertainties; zero for outliers.
    pub(super) weights: Vec<f64>,
    /// Largest step of the integration.
    pub(super) substep: f64,
    /// Cancellation, checked at each evaluation of a law.
    pub(super) watch: &'a Watch<'a>,
}

/// A law with its parameters: the first amplitude, then the coefficients.
pub(super) struct EnvelopeLaw {
    pub(super) terms: DampingModel,
    pub(super) parameters: Vec<f64>,
    /// Covariance of the parameters by the weighted residuals.
    pub(super) covariance: DMatrix<f64>,
    pub(super) chi2: f64,
    pub(super) fitted: Vec<f64>,
}

impl<'a> Fall<'a> {
    /// Prepares the fall for a pendulum of this ω0; no extreme is an outlier.
    pub(super) fn new(half_swings: &'a [HalfSwing], omega0: f64, watch: &'a Watch<'a>) -> Self {
        let largest = half_swings.iter().map(|half| half.amplitude.value).fold(0.0, f64::max);
        Self {
            half_swings,
            rates: DecayRates::new(omega0, largest),
            weights: half_swings
                .iter()
                // Traces without noise have amplitudes without uncertainty, and weights must be finite.
                .map(|half| 1.0 / half.amplitude.uncertainty.max(1e-9 * largest))
                .collect(),
            substep: PI / omega0,
            watch,
        }
    }
}

impl Fall<'_> {
    /// Fits the parameters by least squares, beginning with those of a linear equation; `None` where the data are too few or leave one
    /// undetermined, and where the search does not converge.
    pub(super) fn fit(&self, terms: DampingModel) -> Option<EnvelopeLaw> {
        let solution =
            minimum(self.guess(terms)?, EFFORT, |parameters| self.linearised(terms, parameters)).ok()?;
        if !solution.converged {
            return None;
        }
        let covariance = Design::new(&solution.linearised.jacobian, EXACTNESS).ok()?.covariance();
        let parameters: Vec<f64> = solution.parameters.iter().copied().collect();
        let fitted = self.amplitudes(terms, &parameters);
        let chi2 = solution.linearised.residuals.norm_squared();
        Some(EnvelopeLaw { terms, parameters, covariance, chi2, fitted })
    }

    /// Guesses the parameters by A(t) = A0 − Σ cₙ∫φₙ dt with the measured amplitudes inside the integrals.
    fn guess(&self, terms: DampingModel) -> Option<DVector<f64>> {
        let used = self.weights.iter().filter(|&&weight| weight > 0.0).count();
        if used < terms.count() + 2 {
            return None;
        }
        let mut columns = vec![vec![1.0; self.half_swings.len()]];
        for term in terms.iter() {
            let rate = |half: &HalfSwing| self.rates.at(term, half.amplitude.value);
            let mut integral = vec![0.0];
            for pair in self.half_swings.windows(2) {
                let mean = 0.5 * (rate(&pair[0]) + rate(&pair[1]));
                integral.push(integral[integral.len() - 1] - mean * (pair[1].time - pair[0].time));
            }
            columns.push(integral);
        }
        let rows = self.half_swings.len();
        let matrix = DMatrix::from_fn(rows, columns.len(), |i, j| columns[j][i]);
        let amplitudes = DVector::from_fn(rows, |i, _| self.half_swings[i].amplitude.value);
        Some(weighted_least_squares(matrix, amplitudes, &self.weights).ok()?.coefficients)
    }

    /// Differences of the law from the amplitudes, over their uncertainties, with their derivatives by differences.
    fn linearised(
        &self,
        terms: DampingModel,
        parameters: &DVector<f64>,
    ) -> Result<Linearised, ResidualsError> {
        self.watch.go_on().map_err(|_| ResidualsError::Stopped)?;
        let fitted = self.amplitudes(terms, parameters.as_slice());
        let residuals = -DVector::from_vec(self.residuals(&fitted));
        let mut jacobian = DMatrix::zeros(fitted.len(), parameters.len());
        for k in 0..parameters.len() {
            let mut moved = parameters.clone();
            let step = STEP * if k == 0 { parameters[0] } else { self.typical(terms, k) };
            moved[k] += step;
            for (row, value) in self.amplitudes(terms, moved.as_slice()).iter().enumerate() {
                jacobian[(row, k)] = (value - fitted[row]) / step * self.weights[row];
            }
        }
        let finite = residuals.iter().chain(jacobian.iter()).all(|x| x.is_finite());
        if finite { Ok(Linearised { residuals, jacobian }) } else { Err(ResidualsError::OutOfDomain) }
    }

    /// The coefficient with which a kind of damping alone would halve the amplitude in this time.
    fn typical(&self, terms: DampingModel, parameter: usize) -> f64 {
        let (first, last) = (self.half_swings[0], self.half_swings[self.half_swings.len() - 1]);
        let term = terms.iter().nth(parameter - 1).unwrap_or(DampingKind::Linear);
        0.5 * first.amplitude.value / (self.rates.at(term, first.amplitude.value) * (last.time - first.time))
    }

    /// The amplitudes at the half swings.
    fn amplitudes(&self, terms: DampingModel, parameters: &[f64]) -> Vec<f64> {
        let rate = |amplitude: f64| -> f64 {
            terms.iter().zip(&parameters[1..]).map(|(term, c)| c * self.rates.at(term, amplitude)).sum()
        };
        falling(parameters[0], self.half_swings.iter().map(|half| half.time), self.substep, rate)
    }

    pub(super) fn residuals(&self, fitted: &[f64]) -> Vec<f64> {
        let rows = self.half_swings.iter().zip(fitted).zip(&self.weights);
        rows.map(|((half, fitted), weight)| (half.amplitude.value - fitted) * weight).collect()
    }

    /// Sets the weight of extremes far from the law with all kinds of damping to zero, and returns their number.
    pub(super) fn drop_outliers(&mut self, full: DampingModel) -> usize {
        let mut dropped = 0;
        for _ in 0..5 {
            let Some(curve) = self.fit(full) else { break };
            let residuals = self.residuals(&curve.fitted);
            let Some(middle) = median(residuals.clone()) else { break };
            let deviation = robust_deviation(&residuals).unwrap_or(0.0);
            let far = |r: f64| deviation > 0.0 && (r - middle).abs() > OUTLIER * deviation;
            let rows: Vec<usize> = (0..residuals.len()).filter(|&row| far(residuals[row])).collect();
            for &row in &rows {
                self.weights[row] = 0.0;
            }
            dropped += rows.len();
            if rows.is_empty() {
                break;
            }
        }
        dropped
    }
}
