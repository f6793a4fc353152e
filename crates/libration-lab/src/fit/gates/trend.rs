//! The period at the beginning, from periods that fall with the amplitude.

use nalgebra::{DMatrix, DVector};

use crate::fit::significance::SIGNIFICANT;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{LinearFit, count, least_squares};

/// Numbers of rows above which a line is fitted, a parabola, and polynomials of third and fourth degree.
const ROWS_FOR_DEGREES: [usize; 4] = [4, 8, 16, 32];

/// The period at a time before the first ones, by a polynomial through all periods or, if polynomials of higher degrees do not converge to it,
/// through the first half, quarter or so of them, if that is less uncertain; `None` if they are too few for a line, since the mean of a few is the
/// period of a later and smaller swing.
pub fn at_the_beginning(times: &[f64], periods: &[f64], time: f64) -> Option<Uncertain> {
    let whole = extrapolated(times, periods, time)?;
    if whole.converges {
        return Some(whole.period);
    }
    let halves = std::iter::successors(Some(times.len() / 2), |rows| Some(rows / 2));
    let parts = halves.take_while(|rows| *rows >= ROWS_FOR_DEGREES[1]);
    let parts = parts.filter_map(|rows| extrapolated(&times[..rows], &periods[..rows], time));
    let best = std::iter::once(whole).chain(parts).map(|polynomial| polynomial.period);
    best.filter(|best| best.uncertainty.is_finite())
        .min_by(|one, other| one.uncertainty.total_cmp(&other.uncertainty))
}

/// The period at a time by polynomials of several degrees.
struct Extrapolated {
    period: Uncertain,
    /// `true` if the next degree would change it by less than half of the last change, or chance explains the changes.
    converges: bool,
}

/// The period at a time by the polynomial of the highest degree. Its uncertainty contains the difference from a polynomial of lower degree, since
/// the damping law is not known, and at least the sum of the following differences if their ratio r is constant: r/(1 − r) of the last one.
fn extrapolated(times: &[f64], periods: &[f64], time: f64) -> Option<Extrapolated> {
    let degree = ROWS_FOR_DEGREES.iter().filter(|&&rows| times.len() >= rows).count();
    if degree == 0 {
        return None;
    }
    let value = |degree: usize| polynomial(times, periods, time, degree);
    let best = value(degree)?;
    let lower = |by: usize| degree.checked_sub(by).and_then(value).map(|period| period.value);
    let change = lower(1).map_or(0.0, |lower| (best.value - lower).abs());
    let ratio = match (lower(1), lower(2)) {
        (Some(one), Some(two)) if change > SIGNIFICANT * best.uncertainty => change / (one - two).abs(),
        _ => 0.0,
    };
    let rest = if ratio < 1.0 { ratio / (1.0 - ratio) } else { f64::INFINITY };
    Some(Extrapolated { period: best.with_error(change * rest.max(1.0)), converges: rest <= 1.0 })
}

/// The value at a time of a polynomial through values at others, and its uncertainty by the scatter.
fn polynomial(times: &[f64], periods: &[f64], time: f64, degree: usize) -> Option<Uncertain> {
    let (fit, _) = fitted(times, periods, time, degree)?;
    let dof = count(times.len().saturating_sub(degree + 1).max(1));
    let uncertainty = (fit.chi2() / dof * fit.covariance[(0, 0)]).sqrt();
    Some(Uncertain { value: fit.coefficients[0], uncertainty })
}

/// The value and the slope at a time of a line through values at others.
pub(super) fn value_and_slope(times: &[f64], values: &[f64], time: f64) -> Option<[f64; 2]> {
    let (fit, scale) = fitted(times, values, time, 1)?;
    Some([fit.coefficients[0], fit.coefficients[1] / scale])
}

/// A polynomial in powers of the time after the wanted one, divided by a scale, so that its constant term is the result.
fn fitted(times: &[f64], values: &[f64], time: f64, degree: usize) -> Option<(LinearFit, f64)> {
    let (first, last) = (times.first()?, times.last()?);
    let scale = (last - first).max(f64::MIN_POSITIVE);
    let power = |t: f64, k: usize| (0..k).fold(1.0, |product, _| product * (t - time) / scale);
    let matrix = DMatrix::from_fn(times.len(), degree + 1, |i, k| power(times[i], k));
    Some((least_squares(&matrix, &DVector::from_row_slice(values)).ok()?, scale))
}
