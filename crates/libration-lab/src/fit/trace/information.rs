//! How well a model explains data, for what it costs.

use super::{TraceFit, huber};
use crate::statistics::akaike;
use crate::statistics::count;

/// Akaike's criterion with its correction for few data, up to a constant; infinite where the data are too few to judge. As many
/// rows count as are independent, the same number for all models that are compared.
///
/// With a scale, also the same for all models, outliers count by Huber's loss (E. Ronchetti, Stat. Probab. Lett. 3, 21 (1985),
/// doi:10.1016/0167-7152(85)90006-9); without one it is that of the residuals.
pub(super) fn information(fit: &TraceFit, independent_rows: f64, scale: Option<f64>) -> f64 {
    // The variance of the residuals is a parameter too.
    let cost = akaike::cost(independent_rows, count(fit.parameters.len() + 1));
    cost.map_or(f64::INFINITY, |cost| misfit(&fit.standard_residuals, independent_rows, scale) + cost)
}

fn misfit(residuals: &[f64], independent_rows: f64, scale: Option<f64>) -> f64 {
    let rows = count(residuals.len());
    match scale {
        Some(scale) => 2.0 * huber::loss(residuals, scale) * independent_rows / rows,
        None => {
            let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
            akaike::misfit_of_scatter(squares / rows, independent_rows)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half as large residuals of 100 rows that count as 50: 50 ln 4.
    #[test]
    fn rows_that_are_alike_count_less() {
        let [one, half] = [1.0, 0.5].map(|size| misfit(&[size; 100], 50.0, None));
        assert!((one - half - 50.0 * libm::log(4.0)).abs() < 1e-12);
    }

    /// 2(½·4 + 1.345·(10 − ½·1.345)) by hand, where squares would give 104.
    #[test]
    fn outliers_count_by_their_size_where_a_scale_is_given() {
        let residuals = [1.0, 1.0, 1.0, 1.0, 10.0];
        let expected = 4.0 + 2.0 * 1.345 * (10.0 - 0.6725);
        assert!((misfit(&residuals, 5.0, Some(1.0)) - expected).abs() < 1e-12);
        assert!((misfit(&residuals, 2.5, Some(1.0)) - 0.5 * expected).abs() < 1e-12);
    }
}
