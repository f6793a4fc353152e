//! The correlation of residuals with those of the rows before.

use libration_lab::fit::trace::Autocorrelation;
use libration_lab::internals::statistics::count;

fn noise(rows: usize) -> Vec<f64> {
    // Sums of twelve have a variance of one, and little is missing of a normal distribution.
    let mut random = libration_lab::internals::fit::trace::random::Random::new(7);
    let mut uniform = || count(random.below(1 << 30)) / count(1 << 30) - 0.5;
    (0..rows).map(|_| (0..12).map(|_| uniform()).sum()).collect()
}

#[test]
fn noise_is_noise() {
    let autocorrelation = Autocorrelation::of_series(&[noise(2000)]);
    assert!(autocorrelation.is_noise() && autocorrelation.time < 1.2, "{autocorrelation:?}");
}

#[test]
fn a_moving_average_is_not() {
    let noise = noise(4000);
    let smooth: Vec<f64> = noise.windows(4).map(|four| four.iter().sum()).collect();
    let autocorrelation = Autocorrelation::of_series(&[smooth]);
    // Triangular correlations 3/4, 1/2, 1/4.
    assert!(
        !autocorrelation.is_noise() && (autocorrelation.time - 4.0).abs() < 0.8,
        "{}",
        autocorrelation.time
    );
    assert!((autocorrelation.correlations[1] - 0.75).abs() < 0.05);
}

#[test]
fn little_is_no_reason_to_doubt() {
    assert!(Autocorrelation::of_series(&[]).is_noise());
    assert!(Autocorrelation::of_series(&[vec![0.0; 30]]).is_noise());
    assert!(Autocorrelation::of_series(&[vec![1.0, -1.0]]).is_noise());
}
