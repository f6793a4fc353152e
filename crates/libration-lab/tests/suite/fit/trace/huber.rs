//! Huber's weights, which are smaller for outliers.

use libration_lab::internals::fit::trace::huber::{
    BOUND, bounded, factor, is_outlier, loss, scale, variance,
};

/// At the bound and one ulp next to it.
#[test]
fn rows_count_in_full_up_to_the_bound() {
    let bound = 2.0 * BOUND;
    assert!([0.0, -1.0, bound, -bound].iter().all(|&x| factor(x, 2.0).to_bits() == 1.0_f64.to_bits()));
    assert!(factor(bound.next_up(), 2.0) <= 1.0);
    // The square of the factor times the residual is the bound.
    assert!((factor(8.0 * bound, 2.0) - 0.125_f64.sqrt()).abs() < 1e-15);
}

#[test]
fn the_loss_is_half_the_square_and_beyond_the_bound_its_tangent() {
    assert!((loss(&[2.0, -2.0], 2.0) - 1.0).abs() < 1e-15);
    // 1.345·(3 − 0.6725) by hand.
    assert!((loss(&[6.0], 2.0) - 3.1304875).abs() < 1e-12);
    let step = 1e-6;
    let slope = (loss(&[BOUND + step], 1.0) - loss(&[BOUND - step], 1.0)) / (2.0 * step);
    assert!((slope - BOUND).abs() < 1e-6);
}

/// Residuals ±1 eight times and ±3 twice, of two parameters: by hand with scale 1.4826, bound 1.9941, part 0.8,
/// correction 1 + 0.2·0.25, squares 8 + 2·3.9765.
#[test]
fn the_variance_has_the_correction_for_the_parameters() {
    let residuals = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 3.0, -3.0];
    let bound = 1.345 * 1.482602218505602;
    let expected = 1.05 * 1.05 * (8.0 + 2.0 * bound * bound) / 8.0 / 0.64;
    assert!((variance(&residuals, 2) - expected).abs() < 1e-12);
}

#[test]
fn outliers_answer_as_if_they_were_at_the_bound() {
    let bounded = bounded(&[1.0, -1.0, 1.0, -100.0]);
    let bound = BOUND * scale(&[1.0, -1.0, 1.0, -100.0]);
    assert!(
        (bounded[0] - 1.0 / 0.75).abs() < 1e-15 && (bounded[3] + bound / 0.75).abs() < 1e-15,
        "{bounded:?}"
    );
}

#[test]
fn outliers_begin_at_five_deviations() {
    assert!(!is_outlier(10.0, 2.0) && is_outlier(10.0_f64.next_up(), 2.0) && is_outlier(-10.1, 2.0));
    assert!(!is_outlier(1.0, 0.0), "without a scale there is none");
}
