//! Akaike's criterion with its correction for few data, up to a constant that all models of the same data share.

use libration_lab::internals::statistics::akaike::{cost, of_chi_squared, of_scatter};

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
