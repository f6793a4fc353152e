//! The harmonics of a window of a few swings, by least squares with a phase that the first harmonic defines.
//!
//! Columns next to a constant and a drift of it: cos φ and sin φ with quartics in time, cos nφ and sin nφ with the power of the first
//! harmonic's amplitude with which they grow by theory. The phase φ, a quartic in time, is the one for which the coefficient of sin φ
//! vanishes: it is corrected by that coefficient until nothing changes.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::theory::{Growth, Theory};
use crate::measurement::Observable;
use crate::statistics::{Design, LinearFit, ROUNDING, count, robust_deviation};

/// Distance from the harmonics, in robust standard deviations, above which rows do not count: one in two million normal errors.
const OUTLIER: f64 = 5.0;
/// Passes in which rows count by their distance, before those beyond [`OUTLIER`] are left out; then passes until these are
/// the same. With a third of the rows of a window spoilt by the amplitude of the swing 3 and 9 were enough.
const GENTLE: usize = 3;
const PASSES: usize = 9;
/// Corrections of the phase. They shrink tenfold each or faster where swings are clear.
const CORRECTIONS: usize = 40;
/// Corrections below this (rad) are rounding errors of some thousand rows.
const SETTLED: f64 = 1e-9;
/// Size of corrections below which the amplitude of the first harmonic is right to an eighth.
const NEAR: f64 = 0.5;
/// Positions in the window at which the phase is corrected, from −1 to 1: close to Chebyshev nodes.
const NODES: [f64; TERMS] = [-0.95, -0.59, 0.0, 0.59, 0.95];

/// Coefficients of phase and amplitude in time. Where an amplitude of 60° falls by a third to each side, four left a third harmonic
/// off by a hundredth, five by less than a thousandth.
const TERMS: usize = 5;
/// First column of each kind: a constant, a drift, those of cos φ and of sin φ, and two of each further harmonic.
const COSINE: usize = 2;
const SINE: usize = COSINE + TERMS;
const OTHERS: usize = SINE + TERMS;

/// The rows of a window.
#[derive(Clone, Debug)]
pub(super) struct WindowRows<'a> {
    /// The index of its first row in the trace.
    pub(super) first: usize,
    pub(super) times: &'a [f64],
    pub(super) values: &'a [f64],
    pub(super) uncertainties: Option<&'a [f64]>,
    pub(super) observable: Observable,
    /// The ends of the window, in s.
    pub(super) ends: [f64; 2],
    /// The period to begin with, in s.
    pub(super) period: f64,
    /// Number of harmonics.
    pub(super) highest: usize,
}

/// Results of a window.
#[derive(Clone, Debug)]
pub(super) struct WindowFit {
    /// The phase as a polynomial from −1 to 1.
    phase: [f64; TERMS],
    /// Time of the middle, in s.
    pub(super) middle: f64,
    half: f64,
    fit: LinearFit,
    design: Design,
    /// The columns' rows: position in the window from −1 to 1, and weight.
    places: Vec<f64>,
    weights: Vec<f64>,
    /// Rows of the trace that do not count.
    pub(super) outliers: Vec<usize>,
    pub(super) theory: Theory,
}

/// Number of columns for this number of harmonics.
pub(super) fn columns(highest: usize) -> usize {
    OTHERS + 2 * (highest - 1)
}

/// The column of cos nφ in the middle of the window; that of the constant for n = 0.
pub(super) fn cosine_column(n: usize) -> usize {
    match n {
        0 => 0,
        1 => COSINE,
        n => OTHERS + 2 * (n - 2),
    }
}

/// The column of sin nφ, for n from 2 on.
pub(super) fn sine_column(n: usize) -> usize {
    OTHERS + 2 * (n - 2) + 1
}

/// The phase and the shape during the iteration.
#[derive(Clone, Debug)]
struct PhaseAndShape {
    phase: [f64; TERMS],
    /// The amplitude of the first harmonic over that in the middle.
    shape: [f64; TERMS],
    /// Growth of the harmonics from n = 0.
    growths: Vec<Growth>,
}

impl WindowRows<'_> {
    /// Fits the harmonics, without outliers; `None` where the phase does not settle, the rows do not determine the coefficients, or no swing
    /// of a pendulum is so large.
    pub(super) fn fit(&self) -> Option<WindowFit> {
        let half = 0.5 * (self.ends[1] - self.ends[0]);
        let middle = 0.5 * (self.ends[1] + self.ends[0]);
        let positions: Vec<f64> = self.times.iter().map(|time| (time - middle) / half).collect();
        let inverses: Vec<f64> = match self.uncertainties {
            Some(column) => column.iter().map(|uncertainty| uncertainty.recip()).collect(),
            None => vec![1.0; positions.len()],
        };
        let growths = (0..=self.highest).map(Growth::by_number).collect();
        let phase = [0.0, TAU * half / self.period, 0.0, 0.0, 0.0];
        let mut state = PhaseAndShape { phase, shape: [1.0, 0.0, 0.0, 0.0, 0.0], growths };
        let mut weights = inverses.clone();
        let mut settled = self.settle(&positions, &weights, half, &mut state)?;
        for pass in 0..PASSES {
            let residuals = settled.residuals(self.values, &positions, &inverses, &state);
            let Some(scale) = robust_deviation(&residuals).filter(|scale| *scale > 0.0) else { break };
            let renewed: Vec<f64> = inverses
                .iter()
                .zip(&residuals)
                .map(|(inverse, residual)| inverse * weight(residual.abs() / scale, pass))
                .collect();
            if renewed == weights {
                break;
            }
            weights = renewed;
            settled = self.settle(&positions, &weights, half, &mut state)?;
        }
        let Settled { fit, design, theory } = settled;
        let is_outlier = |row: &usize| weights[*row] == 0.0;
        let outliers = (0..weights.len()).filter(is_outlier).map(|row| self.first + row).collect();
        Some(WindowFit {
            phase: state.phase,
            middle,
            half,
            fit,
            design,
            places: positions,
            weights,
            outliers,
            theory,
        })
    }

    /// Corrects the phase until sin φ has no part.
    fn settle(
        &self,
        positions: &[f64],
        weights: &[f64],
        half: f64,
        state: &mut PhaseAndShape,
    ) -> Option<Settled> {
        let values = weights.iter().zip(self.values).map(|(weight, value)| weight * value);
        let values = DVector::from_iterator(positions.len(), values);
        for _ in 0..CORRECTIONS {
            let matrix = state.matrix(positions, weights, self.highest);
            let design = Design::new(&matrix, ROUNDING).ok()?;
            let fit = design.solve(&values).ok()?;
            let [cosine, sine] =
                [COSINE, SINE].map(|first| std::array::from_fn(|j| fit.coefficients[first + j]));
            let correction = lag(&cosine, &sine)?;
            let size = NODES.iter().map(|x| polynomial(&correction, *x).abs()).fold(0.0, f64::max);
            state.phase = std::array::from_fn(|j| state.phase[j] - correction[j]);
            let first = libm::hypot(cosine[0], sine[0]);
            let frequency = state.phase[1] / half;
            let theory = Theory::new(first, frequency, self.observable, self.highest);
            if size < SETTLED {
                return Some(Settled { fit, design, theory: theory? });
            }
            // Where the phase is far off a part of the first harmonic is in the sine.
            if let (Some(theory), true) = (theory, size < NEAR) {
                state.growths = (0..=self.highest).map(|n| theory.growth(n)).collect();
                state.shape = cosine.map(|coefficient| coefficient / cosine[0]);
            }
        }
        None
    }
}

/// Factor of a row's weight, by its residual in standard deviations.
fn weight(size: f64, pass: usize) -> f64 {
    match pass < GENTLE {
        true => size.max(1.0).recip().sqrt(),
        false if size > OUTLIER => 0.0,
        false => 1.0,
    }
}

/// Results with the settled phase.
#[derive(Clone, Debug)]
struct Settled {
    fit: LinearFit,
    design: Design,
    theory: Theory,
}

impl Settled {
    /// Residuals of all rows, in units of their own uncertainties.
    fn residuals(
        &self,
        values: &[f64],
        positions: &[f64],
        inverses: &[f64],
        state: &PhaseAndShape,
    ) -> Vec<f64> {
        let highest = (self.fit.coefficients.len() - OTHERS) / 2 + 1;
        let fitted = state.matrix(positions, inverses, highest) * &self.fit.coefficients;
        values
            .iter()
            .zip(inverses)
            .zip(fitted.iter())
            .map(|((value, inverse), fitted)| value * inverse - fitted)
            .collect()
    }
}

impl PhaseAndShape {
    /// The columns at these positions, each row times its weight.
    fn matrix(&self, positions: &[f64], weights: &[f64], highest: usize) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(positions.len(), columns(highest));
        for (row, (&x, &weight)) in positions.iter().zip(weights).enumerate() {
            let mut put = |column: usize, value: f64| matrix[(row, column)] = weight * value;
            let phase = polynomial(&self.phase, x);
            let shape = polynomial(&self.shape, x).max(0.0);
            put(0, 1.0);
            put(1, x);
            let (sine, cosine) = libm::sincos(phase);
            let mut power = 1.0;
            for j in 0..TERMS {
                put(COSINE + j, power * cosine);
                put(SINE + j, power * sine);
                power *= x;
            }
            for n in 2..=highest {
                let (sine, cosine) = libm::sincos(count(n) * phase);
                let size = self.growths[n].size(shape);
                put(cosine_column(n), size * cosine);
                put(sine_column(n), size * sine);
            }
        }
        matrix
    }
}

/// Phase lag of c cos φ + s sin φ relative to cos φ, as a polynomial through the nodes.
fn lag(cosine: &[f64; TERMS], sine: &[f64; TERMS]) -> Option<[f64; TERMS]> {
    let mut lags = NODES.map(|x| libm::atan2(polynomial(sine, x), polynomial(cosine, x)));
    for node in 1..NODES.len() {
        lags[node] -= TAU * libm::round((lags[node] - lags[node - 1]) / TAU);
    }
    let powers =
        SMatrix::<f64, TERMS, TERMS>::from_fn(|node, j| (0..j).fold(1.0, |power, _| power * NODES[node]));
    let lag = powers.lu().solve(&SVector::<f64, TERMS>::from(lags))?;
    lag.iter().all(|coefficient| coefficient.is_finite()).then(|| lag.into())
}

fn polynomial(coefficients: &[f64; TERMS], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

impl WindowFit {
    /// Number of rows that count.
    pub(super) fn rows(&self) -> usize {
        self.places.len() - self.outliers.len()
    }

    /// Number of rows used minus that of coefficients.
    pub(super) fn degrees_of_freedom(&self) -> usize {
        self.rows().saturating_sub(self.fit.coefficients.len())
    }

    /// The weighted sum of squares of the residuals.
    pub(super) fn chi2(&self) -> f64 {
        self.fit.chi2()
    }

    pub(super) fn coefficient(&self, column: usize) -> f64 {
        self.fit.coefficients[column]
    }

    /// Covariance of two coefficients in units of the variance of a row.
    pub(super) fn covariance(&self, one: usize, other: usize) -> f64 {
        self.fit.covariance[(one, other)]
    }

    /// Frequency of the first harmonic in the middle, in rad/s.
    pub(super) fn frequency(&self) -> f64 {
        self.phase[1] / self.half
    }

    /// Variance of the frequency in units of the variance of a row.
    pub(super) fn frequency_variance(&self) -> f64 {
        let size = self.coefficient(COSINE) * self.half;
        self.covariance(SINE + 1, SINE + 1) / (size * size)
    }

    pub(super) fn phase_variance(&self) -> f64 {
        let size = self.coefficient(COSINE);
        self.covariance(SINE, SINE) / (size * size)
    }

    /// Parts of cos mφ and of sin mφ in the residuals.
    pub(super) fn noise_at(&self, multiple: f64) -> [Wave; 2] {
        let wave = |of: fn(f64) -> f64| {
            let rows = self.places.iter().zip(&self.weights);
            let wave = rows.map(|(&x, weight)| weight * of(multiple * polynomial(&self.phase, x)));
            let wave = DVector::from_iterator(self.places.len(), wave);
            let free = self.design.without_span(&wave);
            let part = free.dot(&self.fit.residuals);
            Wave { square: part * part, free: free.norm_squared(), whole: wave.norm_squared() }
        };
        [wave(libm::cos), wave(libm::sin)]
    }
}

/// Component of the residuals along a wave.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wave {
    /// The square of their product with the wave.
    pub(super) square: f64,
    /// The mean of that square for noise of unit variance: the square of the component of the wave outside the span of the columns.
    pub(super) free: f64,
    /// The square of the whole wave.
    pub(super) whole: f64,
}
