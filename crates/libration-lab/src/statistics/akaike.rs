//! Akaike's criterion with its correction for few data, up to a constant that all models of the same data share.

use super::count;

/// Where the variances of the data are known: χ² and what the parameters cost.
pub(crate) fn of_chi_squared(chi2: f64, data: f64, parameters: usize) -> Option<f64> {
    cost(data, count(parameters)).map(|cost| chi2 + cost)
}

/// Where the variance is not known and so is a parameter too: n ln(mean square of the residuals) and what they cost.
pub(crate) fn of_scatter(mean_square: f64, data: f64, parameters: usize) -> Option<f64> {
    cost(data, count(parameters + 1)).map(|cost| misfit_of_scatter(mean_square, data) + cost)
}

/// n ln(mean square); as if the least number remained where nothing is left.
pub(crate) fn misfit_of_scatter(mean_square: f64, data: f64) -> f64 {
    data * libm::log(mean_square.max(f64::MIN_POSITIVE))
}

/// 2k + 2k(k + 1)/(n − k − 1) for k parameters, the variance among them where it is unknown, of n independent data; none
/// where the data are too few to judge so many.
///
/// # References
/// N. Sugiura, Commun. Stat. Theory Methods 7, 13 (1978), doi:10.1080/03610927808827599; K. P. Burnham and D. R. Anderson,
/// *Model Selection and Multimodel Inference*, 2nd ed., Springer 2002, doi:10.1007/b97636, section 2.4.
pub(crate) fn cost(data: f64, parameters: f64) -> Option<f64> {
    let spare = data - parameters - 1.0;
    (spare > 0.0).then(|| 2.0 * parameters + 2.0 * parameters * (parameters + 1.0) / spare)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n = 10, k = 3: 6 + 24/6; the limit of many data is 2k.
    #[test]
    fn parameters_cost_more_where_data_are_few() {
        assert_eq!(cost(10.0, 3.0), Some(10.0));
        assert_eq!(cost(5.0, 3.0), Some(30.0));
        assert!((cost(1e12, 3.0).unwrap() - 6.0).abs() < 1e-9);
    }

    #[test]
    fn as_many_parameters_as_data_cannot_be_judged() {
        assert_eq!(cost(4.0, 3.0), None);
        assert_eq!(cost(3.0, 3.0), None);
        assert!(cost(4.0_f64.next_up(), 3.0).is_some());
    }

    /// n = 10, k = 2 and the variance: 10 ln 4 + 10; the same with known variances: 7 + 4 + 12/7.
    #[test]
    fn an_unknown_variance_costs_a_parameter() {
        assert!((of_scatter(4.0, 10.0, 2).unwrap() - 10.0 * libm::log(4.0) - 10.0).abs() < 1e-12);
        assert!((of_chi_squared(7.0, 10.0, 2).unwrap() - 11.0 - 12.0 / 7.0).abs() < 1e-12);
        assert!(of_scatter(0.0, 10.0, 2).unwrap().is_finite());
        assert_eq!((of_scatter(4.0, 4.0, 2), of_chi_squared(7.0, 3.0, 2)), (None, None));
    }
}
