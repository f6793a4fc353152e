//! The rows that count.

use std::borrow::Cow;

use libration_lab::internals::fit::trace::series::Series;
use libration_lab::measurement::Observable;

fn series<'a>(times: &'a [f64], values: &'a [f64], weights: &'a [f64]) -> Series<'a> {
    let [times, values, weights] = [times, values, weights].map(Cow::Borrowed);
    Series { observable: Observable::Angle, times, values, weights }
}

/// A decaying swing compared with an undamped one, in phase and with a final difference of up to half a turn.
#[test]
fn the_correlation_tells_the_phase_and_not_the_amplitude() {
    let times: Vec<f64> = (0..5000).map(|row| 0.02 * f64::from(row)).collect();
    let values: Vec<f64> = times.iter().map(|t| libm::exp(-0.05 * t) * libm::cos(3.0 * t)).collect();
    let weights = vec![2.0; 5000];
    let series = series(&times, &values, &weights);
    for (phase, expected) in [(0.0, 0.98..1.0), (0.7, 0.7..0.85), (3.1, -1.0..-0.85)] {
        let fitted = times.iter().map(|t| libm::cos((3.0 + 0.01 * phase) * t));
        let residuals: Vec<f64> = fitted.zip(&values).map(|(fitted, value)| 2.0 * (fitted - value)).collect();
        let computed = series.least_correlation(&residuals);
        assert!(expected.contains(&computed), "{phase}: {computed}");
    }
    let still: Vec<f64> = values.iter().map(|value| -2.0 * value).collect();
    assert!(series.least_correlation(&still) == 0.0, "what does not move has no phase");
}
