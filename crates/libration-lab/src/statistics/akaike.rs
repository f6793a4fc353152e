//! Akaike's criterion with its correction for few data, up to a constant that all models of the same data share.

use super::count;

/// Criterion where the variances of the data are known: χ² plus the cost of the parameters.
pub fn of_chi_squared(chi2: f64, data: f64, parameters: usize) -> Option<f64> {
    cost(data, count(parameters)).map(|cost| chi2 + cost)
}

/// Criterion where the variance is not known and so is a parameter too: n ln(mean square of the residuals) plus the cost of the parameters.
pub fn of_scatter(mean_square: f64, data: f64, parameters: usize) -> Option<f64> {
    cost(data, count(parameters + 1)).map(|cost| misfit_of_scatter(mean_square, data) + cost)
}

/// n ln(mean square); a mean square of zero counts as the smallest number.
pub(crate) fn misfit_of_scatter(mean_square: f64, data: f64) -> f64 {
    data * libm::log(mean_square.max(f64::MIN_POSITIVE))
}

/// 2k + 2k(k + 1)/(n − k − 1) for k parameters, the variance among them where it is unknown, of n independent data; `None` where the data are too few
/// for this number of parameters.
///
/// # References
/// N. Sugiura, Commun. Stat. Theory Methods 7, 13 (1978), doi:10.1080/03610927808827599; K. P. Burnham and D. R. Anderson,
/// *Model Selection and Multimodel Inference*, 2nd ed., Springer 2002, doi:10.1007/b97636, section 2.4.
pub fn cost(data: f64, parameters: f64) -> Option<f64> {
    let spare = data - parameters - 1.0;
    (spare > 0.0).then(|| 2.0 * parameters + 2.0 * parameters * (parameters + 1.0) / spare)
}
