//! Weights that depend on the solution: effective variances contain the derivative of the period with respect to the amplitude.

use libration_lab::fit::{FitError, Law, PeriodTable, Uncertainties, Weighting};
use libration_lab::internals::fit::effective_weights::{Weighted, settled};
use libration_lab::internals::fit::law::Point;

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
        (scale - 1.0 - variance).abs() < 1e-15 && (points[1].variance(scale) / variance - 1.0).abs() < 1e-11
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
