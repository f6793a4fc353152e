//! The criterion by which models are compared.

use libration_lab::internals::fit::trace::information::misfit;

/// Residuals half as large in 100 rows that count as 50: 50 ln 4.
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
