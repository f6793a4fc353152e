//! Weights that belong to what they are to find: effective variances depend on by how much the period changes with the amplitude.

use super::law::Point;
use super::{FitError, Weighting};

/// The weights settle by a factor of (σ of T0)/T0 or so each time.
const MOST_ROUNDS: usize = 100;

/// What is found with weights.
pub(super) trait Weighted {
    /// By what the slope of the law is multiplied: T0, or T0β.
    fn scale(&self) -> f64;

    /// A change of the scale that is none: rounding makes less of one, and so would the next round.
    fn negligible(&self) -> f64;
}

/// What `solve` finds with the weights that belong to it, one over standard deviations, and the variances; with unit weights, and no
/// variances, without uncertainties.
///
/// # Errors
/// [`FitError::NoConvergence`] of these parameters, or what `solve` says.
pub(super) fn settled<S: Weighted>(
    points: &[Point],
    weighting: Weighting,
    parameters: &'static str,
    solve: impl Fn(&[f64]) -> Result<S, FitError>,
) -> Result<(S, Option<Vec<f64>>), FitError> {
    let mut found = solve(&vec![1.0; points.len()])?;
    if weighting == Weighting::Scatter {
        return Ok((found, None));
    }
    for _ in 0..MOST_ROUNDS {
        let variances: Vec<f64> = points.iter().map(|point| point.variance(found.scale())).collect();
        let weights: Vec<f64> = variances.iter().map(|variance| 1.0 / variance.sqrt()).collect();
        let renewed = solve(&weights)?;
        if (renewed.scale() - found.scale()).abs() <= renewed.negligible() {
            return Ok((renewed, Some(variances)));
        }
        found = renewed;
    }
    Err(FitError::NoConvergence(parameters))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{Law, PeriodTable, Uncertainties};

    struct Found(f64);

    impl Weighted for Found {
        fn scale(&self) -> f64 {
            self.0
        }

        fn negligible(&self) -> f64 {
            1e-12 * self.0.abs()
        }
    }

    fn points(with_uncertainties: bool) -> (Vec<Point>, Weighting) {
        let columns = [0.1, 0.1];
        let given = with_uncertainties.then_some(&columns[..]);
        let uncertainties = Uncertainties { amplitudes: given, periods: given };
        let table = PeriodTable::new(&[1.0, 2.0], &[2.1, 2.5], uncertainties).unwrap();
        (Law::exact().points(&table.rows).unwrap(), table.weighting())
    }

    #[test]
    fn what_is_found_belongs_to_its_own_weights() {
        let (points, weighting) = points(true);
        let solve = |weights: &[f64]| Ok(Found(1.0 + 1.0 / (weights[1] * weights[1])));
        let (Found(scale), variances) = settled(&points, weighting, "T0", solve).unwrap();
        let variance = variances.unwrap()[1];
        assert!(
            (scale - 1.0 - variance).abs() < 1e-15
                && (points[1].variance(scale) / variance - 1.0).abs() < 1e-11
        );
    }

    #[test]
    fn what_does_not_settle_is_refused() {
        let (points, weighting) = points(true);
        // Small weights ask for 1, and those of 1 for 10.
        let to_and_fro = |weights: &[f64]| Ok(Found(if weights[1] < 3.0 { 1.0 } else { 10.0 }));
        let refused = settled(&points, weighting, "T0", to_and_fro).map(|_| ());
        assert_eq!(refused, Err(FitError::NoConvergence("T0")));
    }

    #[test]
    fn without_uncertainties_all_rows_count_alike() {
        let (points, weighting) = points(false);
        let (Found(sum), variances) =
            settled(&points, weighting, "T0", |weights| Ok(Found(weights.iter().sum()))).unwrap();
        assert!((sum - 2.0).abs() < 1e-15 && variances.is_none());
    }
}
