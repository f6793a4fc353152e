//! The period at the beginning, from periods that fall with the amplitude.

use libration_lab::internals::fit::gates::trend::at_the_beginning;

#[test]
fn a_falling_period_is_followed_to_its_beginning() {
    let times: Vec<f64> = (1..=20).map(f64::from).collect();
    let periods: Vec<f64> = times.iter().map(|t| 2.0 + 0.03 * libm::exp(-0.03 * t)).collect();
    let period = at_the_beginning(&times, &periods, 0.0).unwrap();
    assert!((period.value - 2.03).abs() < period.uncertainty && period.uncertainty < 2e-3, "{period:?}");
}

/// The standard error of the intercept of a line, s²(1/n + t̄²/Σ(t − t̄)²) with n − 2 degrees of freedom, as in any text on
/// regression, and by how much the mean differs.
#[test]
fn the_uncertainty_of_a_line_is_that_of_its_intercept() {
    let times: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 5.0];
    let periods = [2.011, 2.009, 2.0065, 2.0048, 2.0021];
    let (mean_time, mean) = (3.0, periods.iter().sum::<f64>() / 5.0);
    let slope = times.iter().zip(&periods).map(|(t, p)| (t - mean_time) * (p - mean)).sum::<f64>() / 10.0;
    let intercept = mean - slope * mean_time;
    let squares: f64 = times
        .iter()
        .zip(&periods)
        .map(|(t, p)| (p - intercept - slope * t) * (p - intercept - slope * t))
        .sum();
    let standard_error = (squares / 3.0 * (1.0 / 5.0 + mean_time * mean_time / 10.0)).sqrt();
    let period = at_the_beginning(&times, &periods, 0.0).unwrap();
    assert!((period.value - intercept).abs() < 1e-12, "{period:?}");
    let expected = libm::hypot(standard_error, intercept - mean);
    assert!((period.uncertainty / expected - 1.0).abs() < 1e-6, "{period:?} {expected}");
}

/// The mean of three periods is that of a swing after the first.
#[test]
fn few_periods_are_not_extrapolated() {
    assert_eq!(at_the_beginning(&[1.0, 2.0, 3.0], &[2.011, 2.009, 2.0065], 0.0), None);
}

/// T = 2 + 0.3·e^(−0.3t) is 2.3 at the beginning: of 90 periods a polynomial of fourth degree misses it by three times its change over that of third degree.
#[test]
fn periods_that_fall_fast_are_extrapolated_from_the_first_of_them() {
    for rows in [13, 20, 44, 90] {
        let times: Vec<f64> = (1..=rows).map(f64::from).collect();
        let periods: Vec<f64> = times.iter().map(|t| 2.0 + 0.3 * libm::exp(-0.3 * t)).collect();
        let period = at_the_beginning(&times, &periods, 0.0).unwrap();
        assert!(
            (period.value - 2.3).abs() < period.uncertainty && period.uncertainty < 0.17,
            "{rows}: {period:?}"
        );
    }
}
