//! What parameters cost in Akaike's criterion.

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
    use super::cost;

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
}
