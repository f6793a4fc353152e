//! How well a model explains data, for what it costs.

use super::{TraceFit, count, huber};

/// Akaike's criterion with its correction for few data, up to a constant (K. P. Burnham and D. R. Anderson, *Model Selection
/// and Multimodel Inference*, Springer 2002, doi:10.1007/b97636). Rows count the less the longer residuals are alike:
/// `time` is how many rows it takes until they are independent, the same for all models that are compared.
///
/// With a scale, also the same for all models, outliers count by Huber's loss (E. Ronchetti, Stat. Probab. Lett. 3, 21 (1985),
/// doi:10.1016/0167-7152(85)90006-9); without one it is that of the residuals.
pub(super) fn information(fit: &TraceFit, time: f64, scale: Option<f64>) -> f64 {
    let residuals = &fit.standard_residuals;
    let rows = (count(residuals.len()) / time.max(1.0)).max(1.0);
    let misfit = match scale {
        Some(scale) => 2.0 * huber::loss(residuals, scale) / time.max(1.0),
        None => {
            let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
            rows * libm::log(squares.max(f64::MIN_POSITIVE) / count(residuals.len()))
        }
    };
    // The variance of the residuals is a parameter too.
    let parameters = count(fit.parameters.len() + 1);
    let correction = 2.0 * parameters * (parameters + 1.0) / (rows - parameters - 1.0).max(1.0);
    misfit + 2.0 * parameters + correction
}
