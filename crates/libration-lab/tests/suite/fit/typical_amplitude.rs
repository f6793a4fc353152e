//! One amplitude for many.

use libration::pendulum::period_ratio;
use libration_lab::internals::fit::typical_amplitude::typical_amplitude;

#[test]
fn the_typical_amplitude_has_the_mean_period() {
    let amplitudes = [0.3, 1.0, 1.2];
    let mean = amplitudes.map(period_ratio).iter().sum::<f64>() / 3.0;
    let typical = typical_amplitude(amplitudes.map(period_ratio).into_iter()).unwrap();
    assert!((period_ratio(typical) - mean).abs() < 1e-14);
    assert_eq!(typical_amplitude(std::iter::empty()), None);
}
