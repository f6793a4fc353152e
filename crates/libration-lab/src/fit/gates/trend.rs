//! The period at the beginning, from periods that fall with the amplitude.

use nalgebra::{DMatrix, DVector};

use crate::fit::Uncertain;
use crate::statistics::{LinearFit, count, least_squares};

/// Numbers of rows from which on a line is fitted, a parabola, and polynomials of third and fourth degree.
const ROWS_FOR_DEGREES: [usize; 4] = [4, 8, 16, 32];

/// The period at a time, by a polynomial through all periods; `None` where they are too few for a line, since the mean of a few is the period of a later
/// and smaller swing. Its uncertainty contains the difference from a polynomial of lower degree,
/// since the law by which the amplitude falls is not known.
pub fn at_the_beginning(times: &[f64], periods: &[f64], time: f64) -> Option<Uncertain> {
    let degree = ROWS_FOR_DEGREES.iter().filter(|&&rows| times.len() >= rows).count();
    if degree == 0 {
        return None;
    }
    let best = polynomial(times, periods, time, degree)?;
    let simpler = polynomial(times, periods, time, degree - 1);
    let difference = simpler.map_or(0.0, |simpler| best.value - simpler.value);
    Some(best.with_error(difference))
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

/// A polynomial in powers of the time since the wanted one, so that the constant is the result, over a scale.
fn fitted(times: &[f64], values: &[f64], time: f64, degree: usize) -> Option<(LinearFit, f64)> {
    let (first, last) = (times.first()?, times.last()?);
    let scale = (last - first).max(f64::MIN_POSITIVE);
    let power = |t: f64, k: usize| (0..k).fold(1.0, |product, _| product * (t - time) / scale);
    let matrix = DMatrix::from_fn(times.len(), degree + 1, |i, k| power(times[i], k));
    Some((least_squares(&matrix, &DVector::from_row_slice(values)).ok()?, scale))
}
