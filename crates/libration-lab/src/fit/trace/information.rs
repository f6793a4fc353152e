//! Information criterion: quality of a model's fit against the number of its parameters.

use super::{TraceFit, huber};
use crate::statistics::akaike;
use crate::statistics::count;

/// Akaike's criterion with its correction for few data, up to a constant; infinite if there are too few data. Only independent
/// rows count, the same number for all models that are compared.
///
/// With a scale, also the same for all models, outliers count by Huber's loss (E. Ronchetti, Stat. Probab. Lett. 3, 21 (1985),
/// doi:10.1016/0167-7152(85)90006-9); without one it is that of the residuals.
pub(super) fn information(fit: &TraceFit, independent_rows: f64, scale: Option<f64>) -> f64 {
    // The variance of the residuals is a parameter too.
    let cost = akaike::cost(independent_rows, count(fit.parameters.len() + 1));
    cost.map_or(f64::INFINITY, |cost| misfit(&fit.standard_residuals, independent_rows, scale) + cost)
}

/// The part of the criterion that is independent of the number of parameters.
pub fn misfit(residuals: &[f64], independent_rows: f64, scale: Option<f64>) -> f64 {
    let rows = count(residuals.len());
    match scale {
        Some(scale) => 2.0 * huber::loss(residuals, scale) * independent_rows / rows,
        None => {
            let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
            akaike::misfit_of_scatter(squares / rows, independent_rows)
        }
    }
}
