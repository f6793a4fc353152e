//! What residuals that are alike from row to row make of uncertainties.
//!
//! The noise is white, or the sum of a white part and of one that forgets itself as exp(−t/τ). Neither τ nor the parts are
//! known: each noise counts by its restricted likelihood (H. D. Patterson and R. Thompson, Biometrika 58, 545 (1971),
//! doi:10.1093/biomet/58.3.545), which heeds what the fitted parameters have taken out of the residuals; white noise
//! counts as much beforehand as all others together. Under each the variance of a least squares estimate is a Σ aᵀ,
//! where a is how the parameter answers to the rows. What the residuals leave open about the noise makes the degrees of
//! freedom of Student's t finite (F. E. Satterthwaite, Biometrics Bull. 2, 110 (1946), doi:10.2307/3002019).

use nalgebra::{Cholesky, DMatrix, DVector};

use super::response::Response;
use crate::measurement::Trace;
use crate::statistics::{count, median};

/// What the noise does to one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Effect {
    /// Its variance over the one it had if the residuals were independent.
    pub(super) inflation: f64,
    /// Of Student's t, by which its intervals are found.
    pub(super) degrees_of_freedom: f64,
}

/// White parts of the variance that are tried; 1 is white noise alone. Of 21 recordings with 0 and ½ alone one swing nearly at rest had an
/// uncertainty 4.3 times as large, with 0.95 too none changed by a twentieth. With ten parts from 0 to 0.9 two preferred another model, and
/// others changed by up to 7 %.
const WHITE_PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.7, 0.85];
/// Times that are tried, in steps between rows: from so short a one, each longer by this factor. From 0.2 and 0.8 on, and with a factor of
/// 1.3, the uncertainty of T0 changed by a tenth in one of twelve recordings (`search.rs`); with 2.2 by a fifth in two.
const SHORTEST: f64 = 0.4;
const FACTOR: f64 = 1.6;
/// Longer times than this part of a trace are drift, and longer ones than so many rows cannot be distinguished from it. With 0.06 the
/// uncertainty of T0 fell by 15 % in one of the twelve, with 0.25 it rose by 5 %; with 100 and 1600 rows nothing changed.
const LONGEST_PART: f64 = 0.125;
const LONGEST_ROWS: f64 = 400.0;
/// Fewer cannot carry an interval: Student's quantile at 95 % is then 4.3.
const LEAST_DEGREES: f64 = 2.0;

/// The effect on each parameter of a least squares problem, by how the parameters answer to the rows.
pub(super) fn effects(traces: &[Trace], problem: &Response) -> Vec<Effect> {
    let response = &problem.matrix;
    let rows = Rows::new(traces, problem);
    let degrees = count(problem.linearised.residuals.len().saturating_sub(response.nrows()).max(1));
    let white = rows.tried(&Noise::WHITE, response, degrees);
    let Some(white) = white else {
        return vec![Effect { inflation: 1.0, degrees_of_freedom: degrees }; response.nrows()];
    };
    let noises = noises(traces);
    let beforehand = -libm::log(count(noises.len().max(1)));
    let others = noises.iter().filter_map(|noise| {
        let tried = rows.tried(noise, response, degrees)?;
        Some(Tried { likelihood: tried.likelihood + beforehand, ..tried })
    });
    let all: Vec<Tried> = [white.clone()].into_iter().chain(others).collect();
    let highest = all.iter().map(|tried| tried.likelihood).fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = all.iter().map(|tried| libm::exp(tried.likelihood - highest)).collect();
    let effect = |place: usize| {
        let logarithms = all.iter().map(|tried| libm::log(tried.variances[place] / white.variances[place]));
        mean_effect(&logarithms.collect::<Vec<f64>>(), &weights, degrees)
    };
    (0..response.nrows()).map(effect).collect()
}

/// From the logarithms of the inflation under each noise. Those of a variance with ν degrees of freedom scatter by √(2/ν).
fn mean_effect(logarithms: &[f64], weights: &[f64], degrees: f64) -> Effect {
    let total: f64 = weights.iter().sum();
    let mean_of = |value: &dyn Fn(f64) -> f64| {
        logarithms.iter().zip(weights).map(|(&x, weight)| weight * value(x)).sum::<f64>() / total
    };
    let mean = mean_of(&|x| x);
    let scatter = mean_of(&|x| (x - mean) * (x - mean));
    let degrees_of_freedom = (1.0 / (1.0 / degrees + 0.5 * scatter)).max(LEAST_DEGREES.min(degrees));
    Effect { inflation: libm::exp(mean), degrees_of_freedom }
}

/// A kind of noise.
#[derive(Clone, Copy, Debug)]
struct Noise {
    /// After what time, in seconds, the part that is not white has forgotten all but 1/e; zero for white noise.
    time: f64,
    /// The part of the variance that is white.
    white: f64,
}

impl Noise {
    const WHITE: Self = Self { time: 0.0, white: 1.0 };

    /// What is left of the remembered part from each row to the next; nothing before the first.
    fn memories(&self, times: &[f64]) -> Vec<f64> {
        let one =
            |pair: &[f64]| if self.time > 0.0 { libm::exp((pair[0] - pair[1]) / self.time) } else { 0.0 };
        [0.0].into_iter().chain(times.windows(2).map(one)).collect()
    }
}

fn noises(traces: &[Trace]) -> Vec<Noise> {
    let steps = traces.iter().flat_map(|trace| trace.times().windows(2).map(|pair| pair[1] - pair[0]));
    let Some(step) = median(steps.collect()) else { return vec![] };
    let span = |trace: &Trace| trace.times()[trace.len() - 1] - trace.times()[0];
    let longest = LONGEST_PART * traces.iter().map(span).fold(0.0, f64::max);
    let times = std::iter::successors(Some(SHORTEST * step), |time| Some(FACTOR * time));
    let times = times.take_while(|&time| time <= longest.min(LONGEST_ROWS * step));
    times.flat_map(|time| WHITE_PARTS.map(|white| Noise { time, white })).collect()
}

/// A noise with what follows from it.
#[derive(Clone, Debug)]
struct Tried {
    /// The logarithm of the restricted likelihood, up to what is the same for all.
    likelihood: f64,
    /// Of each parameter.
    variances: Vec<f64>,
}

/// The rows of one trace.
struct Part<'a> {
    times: &'a [f64],
    first: usize,
    /// Derivatives by the parameters on which these rows depend, with their places, and the residuals at the end.
    columns: Vec<(usize, Vec<f64>)>,
}

/// All rows, with derivatives of the size of one.
struct Rows<'a> {
    parts: Vec<Part<'a>>,
    parameters: usize,
}

impl<'a> Rows<'a> {
    fn new(traces: &'a [Trace], problem: &Response) -> Self {
        let parameters = problem.linearised.jacobian.ncols();
        let sizes: Vec<f64> = problem.linearised.jacobian.column_iter().map(|column| column.norm()).collect();
        let mut parts = vec![];
        let mut first = 0;
        for trace in traces {
            let derivatives = (0..parameters).map(|place| {
                let column = problem.linearised.jacobian.column(place);
                (place, column.rows(first, trace.len()).iter().map(|x| x / sizes[place]).collect())
            });
            let residuals = problem.linearised.residuals.rows(first, trace.len()).iter().copied().collect();
            let depends = |column: &(usize, Vec<f64>)| column.1.iter().any(|x| x.abs() > 0.0);
            let columns = derivatives.filter(depends).chain([(parameters, residuals)]).collect();
            parts.push(Part { times: trace.times(), first, columns });
            first += trace.len();
        }
        Self { parts, parameters }
    }

    /// The likelihood of a noise of unknown size, and the variances under it.
    fn tried(&self, noise: &Noise, response: &DMatrix<f64>, degrees: f64) -> Option<Tried> {
        let p = self.parameters;
        let mut products = DMatrix::<f64>::zeros(p + 1, p + 1);
        let mut logarithm = 0.0;
        for part in &self.parts {
            logarithm += part.add_products(noise, &mut products);
        }
        let right = DVector::from_fn(p, |place, _| products[(place, p)]);
        let normal = Cholesky::new(products.view((0, 0), (p, p)).into_owned())?;
        let determinant: f64 = normal.l_dirty().diagonal().iter().map(|x| 2.0 * libm::log(*x)).sum();
        let left = products[(p, p)] - right.dot(&normal.solve(&right));
        let variance = left / degrees;
        let likelihood = -0.5 * (logarithm + determinant + degrees * libm::log(left));
        let variances: Vec<f64> =
            (0..p).map(|place| variance * self.spread(noise, response, place)).collect();
        let usable = likelihood.is_finite() && variances.iter().all(|variance| *variance > 0.0);
        usable.then_some(Tried { likelihood, variances })
    }

    /// a Σ aᵀ, with the row of the response to one parameter.
    fn spread(&self, noise: &Noise, response: &DMatrix<f64>, place: usize) -> f64 {
        let row = response.row(place);
        let of_part = |part: &Part<'_>| {
            let (mut white, mut shared, mut remembered, mut before) = (0.0, 0.0, 0.0, 0.0);
            for (n, memory) in noise.memories(part.times).into_iter().enumerate() {
                let own = row[part.first + n];
                remembered = memory * (remembered + before);
                white += own * own;
                shared += own * remembered;
                before = own;
            }
            white + 2.0 * (1.0 - noise.white) * shared
        };
        self.parts.iter().map(of_part).sum()
    }
}

impl Part<'_> {
    /// Adds the products of the columns, made white by Kalman's filter, and returns the logarithm of the determinant of
    /// their covariance.
    fn add_products(&self, noise: &Noise, products: &mut DMatrix<f64>) -> f64 {
        let remembered = 1.0 - noise.white;
        let mut expected = vec![0.0; self.columns.len()];
        let mut made_white = expected.clone();
        let (mut spread, mut logarithm) = (remembered, 0.0);
        for (n, memory) in noise.memories(self.times).into_iter().enumerate() {
            if n > 0 {
                spread = memory * memory * spread + remembered * (1.0 - memory * memory);
            }
            let total = spread + noise.white;
            let (gain, root) = (spread / total, total.sqrt());
            logarithm += libm::log(total);
            for ((expected, white), (_, column)) in
                expected.iter_mut().zip(&mut made_white).zip(&self.columns)
            {
                *expected *= memory;
                let news = column[n] - *expected;
                *white = news / root;
                *expected += gain * news;
            }
            spread *= 1.0 - gain;
            for (i, (row, _)) in self.columns.iter().enumerate() {
                for (j, (column, _)) in self.columns[i..].iter().enumerate() {
                    products[(*row, *column)] += made_white[i] * made_white[i + j];
                }
            }
        }
        for i in 0..products.nrows() {
            for j in 0..i {
                products[(i, j)] = products[(j, i)];
            }
        }
        logarithm
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::Observable;

    fn part(times: &[f64]) -> Part<'_> {
        let column = |of: fn(f64) -> f64| times.iter().map(|&time| of(time)).collect::<Vec<f64>>();
        Part { times, first: 0, columns: vec![(0, column(libm::sin)), (1, column(|t| 1.0 + t * t))] }
    }

    fn covariance(noise: &Noise, times: &[f64]) -> DMatrix<f64> {
        DMatrix::from_fn(times.len(), times.len(), |i: usize, j: usize| {
            let memory = libm::exp(-(times[i] - times[j]).abs() / noise.time);
            (1.0 - noise.white) * memory + if i == j { noise.white } else { 0.0 }
        })
    }

    /// Uneven times, and both parts.
    const TIMES: [f64; 6] = [0.0, 0.3, 0.4, 1.0, 1.7, 1.9];
    const NOISE: Noise = Noise { time: 0.8, white: 0.3 };

    /// Against the inverse and the determinant of the whole matrix.
    #[test]
    fn the_filter_gives_what_the_whole_covariance_gives() {
        let (part, whole) = (part(&TIMES), covariance(&NOISE, &TIMES));
        let mut products = DMatrix::zeros(2, 2);
        let logarithm = part.add_products(&NOISE, &mut products);
        assert!((logarithm - libm::log(whole.determinant())).abs() < 1e-12);
        let columns = DMatrix::from_fn(6, 2, |row, place| part.columns[place].1[row]);
        let expected = columns.transpose() * whole.try_inverse().unwrap() * columns;
        assert!((products - expected).norm() < 1e-12);
    }

    #[test]
    fn the_spread_is_that_of_the_whole_covariance() {
        let response = DMatrix::from_fn(1, 6, |_, n| libm::cos(count(n)));
        let rows = Rows { parts: vec![part(&TIMES)], parameters: 1 };
        let expected = (&response * covariance(&NOISE, &TIMES) * response.transpose())[(0, 0)];
        assert!((rows.spread(&NOISE, &response, 0) - expected).abs() < 1e-12);
    }

    /// Half of the weight at e² times the variance: the mean is e, and the logarithms scatter by 1.
    #[test]
    fn noises_that_disagree_leave_few_degrees_of_freedom() {
        let found = mean_effect(&[0.0, 2.0], &[0.5, 0.5], 1e9);
        assert!((found.inflation - std::f64::consts::E).abs() < 1e-12);
        assert!((found.degrees_of_freedom - 2.0).abs() < 1e-6, "{found:?}");
        let alike = mean_effect(&[0.5, 0.5], &[0.9, 0.1], 30.0);
        assert!((alike.degrees_of_freedom - 30.0).abs() < 1e-9);
    }

    #[test]
    fn times_go_up_to_an_eighth_of_the_trace() {
        let times: Vec<f64> = (0..81).map(|row| 0.1 * f64::from(row)).collect();
        let trace =
            Trace::new("eight seconds", Observable::Angle, times.clone(), vec![0.0; 81], None).unwrap();
        let found = noises(&[trace]);
        assert!(found.iter().all(|noise| (0.039..=1.0).contains(&noise.time)));
        assert_eq!(found.len() % WHITE_PARTS.len(), 0);
        assert!(found.iter().any(|noise| noise.time > 1.0 / FACTOR));
    }
}
