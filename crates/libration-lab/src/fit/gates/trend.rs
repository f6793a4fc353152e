//! The period at the beginning, from periods that fall with the amplitude.

use nalgebra::{DMatrix, DVector};

use crate::fit::Uncertain;
use crate::statistics::{count, least_squares};

/// From so many periods on a line is drawn, a parabola, and curves of third and fourth degree.
const ROWS_FOR_DEGREES: [usize; 4] = [4, 8, 16, 32];

/// The period at a time, by a curve through all periods. Its uncertainty contains how much less curved ones would differ,
/// since how the amplitude falls is not known.
pub(super) fn at_the_beginning(times: &[f64], periods: &[f64], time: f64) -> Option<Uncertain> {
    let degree = ROWS_FOR_DEGREES.iter().filter(|&&rows| times.len() >= rows).count();
    let best = polynomial(times, periods, time, degree)?;
    let simpler = (degree > 0).then(|| polynomial(times, periods, time, degree - 1)).flatten();
    let difference = simpler.map_or(0.0, |simpler| best.value - simpler.value);
    Some(best.with_error(difference))
}

/// The value at a time of a polynomial through values at others, and its uncertainty by the scatter.
pub(super) fn polynomial(times: &[f64], periods: &[f64], time: f64, degree: usize) -> Option<Uncertain> {
    let (first, last) = (times.first()?, times.last()?);
    // The basis is in powers of the time since the wanted one, so that the constant is the answer.
    let scale = (last - first).max(f64::MIN_POSITIVE);
    let power = |t: f64, k: usize| (0..k).fold(1.0, |product, _| product * (t - time) / scale);
    let matrix = DMatrix::from_fn(times.len(), degree + 1, |i, k| power(times[i], k));
    let fit = least_squares(&matrix, &DVector::from_row_slice(periods)).ok()?;
    let dof = count(times.len().saturating_sub(degree + 1).max(1));
    let uncertainty = (fit.chi2() / dof * fit.covariance[(0, 0)]).sqrt();
    Some(Uncertain { value: fit.coefficients[0], uncertainty })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_falling_period_is_followed_to_its_beginning() {
        let times: Vec<f64> = (1..=20).map(f64::from).collect();
        let periods: Vec<f64> = times.iter().map(|t| 2.0 + 0.03 * libm::exp(-0.03 * t)).collect();
        let found = at_the_beginning(&times, &periods, 0.0).unwrap();
        assert!((found.value - 2.03).abs() < found.uncertainty && found.uncertainty < 2e-3, "{found:?}");
    }

    /// The standard error of the intercept of a line, s²(1/n + t̄²/Σ(t − t̄)²) with n − 2 degrees of freedom, as in any text on
    /// regression, and by how much the mean differs.
    #[test]
    fn the_uncertainty_of_a_line_is_that_of_its_intercept() {
        let times: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 5.0];
        let periods = [2.011, 2.009, 2.0065, 2.0048, 2.0021];
        let (mean_time, mean) = (3.0, periods.iter().sum::<f64>() / 5.0);
        let slope = times.iter().zip(&periods).map(|(t, p)| (t - mean_time) * (p - mean)).sum::<f64>() / 10.0;
        let intercept = mean - slope * mean_time;
        let squares: f64 = times
            .iter()
            .zip(&periods)
            .map(|(t, p)| (p - intercept - slope * t) * (p - intercept - slope * t))
            .sum();
        let standard_error = (squares / 3.0 * (1.0 / 5.0 + mean_time * mean_time / 10.0)).sqrt();
        let found = at_the_beginning(&times, &periods, 0.0).unwrap();
        assert!((found.value - intercept).abs() < 1e-12, "{found:?}");
        let expected = libm::hypot(standard_error, intercept - mean);
        assert!((found.uncertainty / expected - 1.0).abs() < 1e-6, "{found:?} {expected}");
    }
}
