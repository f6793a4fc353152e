//! Effect of correlated residuals on uncertainties.
//!
//! The noise is white, or the sum of a white part and of one with the correlation exp(−t/τ). Neither τ nor the parts are
//! known: each noise counts by its restricted likelihood (H. D. Patterson and R. Thompson, Biometrika 58, 545 (1971),
//! doi:10.1093/biomet/58.3.545), which accounts for the loss of residuals to the fitted parameters; white noise has the
//! same prior weight as all others together. Under each the variance of a least squares estimate is a Σ aᵀ,
//! where a is the response of the parameter to the rows. The remaining uncertainty about the noise makes the degrees of
//! freedom of Student's t finite (F. E. Satterthwaite, Biometrics Bull. 2, 110 (1946), doi:10.2307/3002019).
//!
//! # Method
//! The residuals of real swings are correlated from row to row. The motion is fitted by least squares as if they were not, which costs little where
//! the spectrum of the noise is smooth about the frequency of the swing; only the uncertainties are computed for the correlated noise. White noise
//! is one end of the same scale.

use libration::internals::progress::Watch;
use libration::progress::Quiet;
use nalgebra::{Cholesky, DMatrix, DVector};

use super::response::Response;
use crate::measurement::Trace;
use crate::parallel;
use crate::statistics::levenberg_marquardt::Linearised;
use crate::statistics::{count, median};

/// Effect of the noise on one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// Ratio of its variance to that of independent residuals.
    pub inflation: f64,
    /// Degrees of freedom of Student's t for its intervals.
    pub degrees_of_freedom: f64,
}

/// Fractions of white noise in the variance that are tried; 1 is white noise alone. Tests with 21 recordings: with 0 and ½ alone, the
/// uncertainty of one swing nearly at rest was 4.3 times as large; with 0.95 in addition, none changed by 5 %. With ten fractions from 0 to
/// 0.9, two recordings preferred another model, and others changed by up to 7 %.
const WHITE_PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.7, 0.85];
/// Shortest correlation time, in steps between rows; each further one is longer by [`FACTOR`]. From 0.2 and 0.8 on, and with a factor of
/// 1.3, the uncertainty of T0 changed by a tenth in one of twelve recordings (`search.rs`); with 2.2 by a fifth in two.
const SHORTEST: f64 = 0.4;
/// Ratio of successive correlation times.
pub const FACTOR: f64 = 1.6;
/// Longest correlation time relative to a trace; longer ones are drift, and ones longer than `LONGEST_ROWS` cannot be distinguished from it. With
/// 0.06 the uncertainty of T0 fell by 15 % in one of the twelve, with 0.25 it rose by 5 %; with 100 and 1600 rows nothing changed.
const LONGEST_PART: f64 = 0.125;
const LONGEST_ROWS: f64 = 400.0;
/// Least degrees of freedom, since fewer cannot carry an interval: Student's quantile at 95 % is then 4.3.
const LEAST_DEGREES: f64 = 2.0;

/// The effect on each parameter of a least squares problem, by the response of the parameters to the rows.
pub(super) fn effects(traces: &[Trace], problem: &Response) -> Vec<Effect> {
    let response = &problem.matrix;
    let rows = Rows::new(traces, problem);
    let degrees = count(problem.linearised.residuals.len().saturating_sub(response.nrows()).max(1));
    let white = rows.tried(0.0, &[1.0], response, degrees).swap_remove(0);
    let Some(white) = white else {
        return vec![Effect { inflation: 1.0, degrees_of_freedom: degrees }; response.nrows()];
    };
    let times = times(traces);
    let noises = times.len() * WHITE_PARTS.len();
    let tried = parallel::map(&times, &Watch::new(&Quiet), |&time, _| {
        rows.tried(time, &WHITE_PARTS, response, degrees)
    });
    let beforehand = -libm::log(count(noises.max(1)));
    let others = tried.into_iter().flatten().flatten();
    let others = others.map(|tried| Tried { likelihood: tried.likelihood + beforehand, ..tried });
    let all: Vec<Tried> = [white.clone()].into_iter().chain(others).collect();
    let highest = all.iter().map(|tried| tried.likelihood).fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = all.iter().map(|tried| libm::exp(tried.likelihood - highest)).collect();
    let effect = |index: usize| {
        let logarithms = all.iter().map(|tried| libm::log(tried.variances[index] / white.variances[index]));
        mean_effect(&logarithms.collect::<Vec<f64>>(), &weights, degrees)
    };
    (0..response.nrows()).map(effect).collect()
}

/// Averages the logarithms of the inflation for each kind of noise. Those of a variance with ν degrees of freedom scatter by √(2/ν).
pub fn mean_effect(logarithms: &[f64], weights: &[f64], degrees: f64) -> Effect {
    let total: f64 = weights.iter().sum();
    let mean_of = |value: &dyn Fn(f64) -> f64| {
        logarithms.iter().zip(weights).map(|(&x, weight)| weight * value(x)).sum::<f64>() / total
    };
    let mean = mean_of(&|x| x);
    let scatter = mean_of(&|x| (x - mean) * (x - mean));
    let degrees_of_freedom = (1.0 / (1.0 / degrees + 0.5 * scatter)).max(LEAST_DEGREES.min(degrees));
    Effect { inflation: libm::exp(mean), degrees_of_freedom }
}

/// The correlation times in seconds, after which a noise has fallen to 1/e.
pub fn times(traces: &[Trace]) -> Vec<f64> {
    let steps = traces.iter().flat_map(|trace| trace.times().windows(2).map(|pair| pair[1] - pair[0]));
    let Some(step) = median(steps.collect()) else { return vec![] };
    let span = |trace: &Trace| trace.times()[trace.len() - 1] - trace.times()[0];
    let longest = LONGEST_PART * traces.iter().map(span).fold(0.0, f64::max);
    let times = std::iter::successors(Some(SHORTEST * step), |time| Some(FACTOR * time));
    times.take_while(|&time| time <= longest.min(LONGEST_ROWS * step)).collect()
}

/// Part of noise with this correlation time that remains after each step; zero before the first row, and for white noise.
pub fn memories(time: f64, times: &[f64]) -> Vec<f64> {
    let one = |pair: &[f64]| if time > 0.0 { libm::exp((pair[0] - pair[1]) / time) } else { 0.0 };
    [0.0].into_iter().chain(times.windows(2).map(one)).collect()
}

/// A noise with its likelihood and the resulting variances.
#[derive(Clone, Debug)]
struct Tried {
    /// The logarithm of the restricted likelihood, up to a constant that is the same for all.
    likelihood: f64,
    /// Variance of each parameter.
    variances: Vec<f64>,
}

/// The rows of one trace.
#[derive(Debug)]
pub struct Part<'a> {
    /// Times in seconds.
    pub times: &'a [f64],
    /// The index of its first row among those of all traces.
    pub first: usize,
    /// Indices of the parameters on which these rows depend, and at the end that of the residuals.
    pub places: Vec<usize>,
    /// Derivatives with respect to these and the residual, row by row.
    pub rows: Vec<f64>,
}

/// All rows, with derivatives scaled to norm one.
#[derive(Debug)]
pub struct Rows<'a> {
    /// Rows of each trace.
    pub parts: Vec<Part<'a>>,
    /// Number of parameters.
    pub parameters: usize,
}

impl<'a> Rows<'a> {
    fn new(traces: &'a [Trace], problem: &Response) -> Self {
        let Linearised { jacobian, residuals } = &problem.linearised;
        let parameters = jacobian.ncols();
        let sizes: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
        let mut parts = vec![];
        let mut first = 0;
        for trace in traces {
            let depends = |index: &usize| {
                jacobian.column(*index).rows(first, trace.len()).iter().any(|x| x.abs() > 0.0)
            };
            let indices: Vec<usize> = (0..parameters).filter(depends).collect();
            let mut rows = Vec::with_capacity(trace.len() * (indices.len() + 1));
            for n in first..first + trace.len() {
                rows.extend(
                    indices.iter().map(|&index| jacobian[(n, index)] / sizes[index]).chain([residuals[n]]),
                );
            }
            let columns = indices.iter().copied().chain([parameters]).collect();
            parts.push(Part { times: trace.times(), first, places: columns, rows });
            first += trace.len();
        }
        Self { parts, parameters }
    }

    /// Evaluates noises with this correlation time and these white parts: the likelihoods, if their sizes are unknown, and the variances under
    /// them.
    fn tried(&self, time: f64, white: &[f64], response: &DMatrix<f64>, degrees: f64) -> Vec<Option<Tried>> {
        let memories: Vec<Vec<f64>> = self.parts.iter().map(|part| memories(time, part.times)).collect();
        let spreads = self.spreads(&memories, response);
        let one = |&white: &f64| self.tried_with(white, &memories, &spreads, degrees);
        white.iter().map(one).collect()
    }

    fn tried_with(
        &self,
        white: f64,
        memories: &[Vec<f64>],
        spreads: &[[f64; 2]],
        degrees: f64,
    ) -> Option<Tried> {
        let p = self.parameters;
        let mut products = DMatrix::<f64>::zeros(p + 1, p + 1);
        let mut logarithm = 0.0;
        for (part, memories) in self.parts.iter().zip(memories) {
            logarithm += part.add_products(white, memories, &mut products);
        }
        let right = DVector::from_fn(p, |row, _| products[(row, p)]);
        let normal = Cholesky::new(products.view((0, 0), (p, p)).into_owned())?;
        let determinant: f64 = normal.l_dirty().diagonal().iter().map(|x| 2.0 * libm::log(*x)).sum();
        let left = products[(p, p)] - right.dot(&normal.solve(&right));
        let variance = left / degrees;
        let likelihood = -0.5 * (logarithm + determinant + degrees * libm::log(left));
        let spread = |[square, shared]: &[f64; 2]| square + 2.0 * (1.0 - white) * shared;
        let variances: Vec<f64> = spreads.iter().map(|spreads| variance * spread(spreads)).collect();
        let usable = likelihood.is_finite() && variances.iter().all(|variance| *variance > 0.0);
        usable.then_some(Tried { likelihood, variances })
    }

    /// The two parts of a Σ aᵀ for each parameter, with the row a of the response: of each row with itself, and with those before it.
    pub fn spreads(&self, memories: &[Vec<f64>], response: &DMatrix<f64>) -> Vec<[f64; 2]> {
        let p = self.parameters;
        let mut sums = vec![[0.0; 2]; p];
        for (part, memories) in self.parts.iter().zip(memories) {
            let (mut remembered, mut before) = (vec![0.0; p], vec![0.0; p]);
            for (memory, coefficients) in
                memories.iter().zip(response.columns(part.first, part.times.len()).column_iter())
            {
                for (index, sum) in sums.iter_mut().enumerate() {
                    remembered[index] = memory * (remembered[index] + before[index]);
                    before[index] = coefficients[index];
                    sum[0] += coefficients[index] * coefficients[index];
                    sum[1] += coefficients[index] * remembered[index];
                }
            }
        }
        sums
    }
}

impl Part<'_> {
    /// Adds the products of the columns, made white by Kalman's filter, and returns the logarithm of the determinant of
    /// their covariance.
    pub fn add_products(&self, white: f64, memories: &[f64], products: &mut DMatrix<f64>) -> f64 {
        let (width, remembered) = (self.places.len(), 1.0 - white);
        let (mut expected, mut made_white) = (vec![0.0; width], vec![0.0; width]);
        let mut sums = vec![0.0; width * width];
        let (mut spread, mut logarithm, mut determinant) = (remembered, 0.0, 1.0);
        for (n, (&memory, row)) in memories.iter().zip(self.rows.chunks_exact(width)).enumerate() {
            if n > 0 {
                spread = memory * memory * spread + remembered * (1.0 - memory * memory);
            }
            let total = spread + white;
            let (gain, scale) = (spread / total, 1.0 / total.sqrt());
            determinant *= total;
            // Each total is between the white part, or the part lost in a step, and one: the product of eight does not underflow.
            if n % 8 == 7 {
                logarithm += libm::log(determinant);
                determinant = 1.0;
            }
            for ((expected, made_white), value) in expected.iter_mut().zip(&mut made_white).zip(row) {
                *expected *= memory;
                let news = value - *expected;
                *made_white = news * scale;
                *expected += gain * news;
            }
            spread *= 1.0 - gain;
            for (sums, entry) in sums.chunks_exact_mut(width).zip(&made_white) {
                for (sum, other) in sums.iter_mut().zip(&made_white) {
                    *sum += entry * other;
                }
            }
        }
        for (sums, row) in sums.chunks_exact(width).zip(&self.places) {
            for (sum, column) in sums.iter().zip(&self.places) {
                products[(*row, *column)] += sum;
            }
        }
        logarithm + libm::log(determinant)
    }
}
