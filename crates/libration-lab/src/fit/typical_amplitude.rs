//! One amplitude for many.

use crate::statistics::mean;
use libration::pendulum::Amplitude;

/// The amplitude, in radians, whose T/T0 is the mean of these; none of none.
pub(super) fn typical_amplitude(period_ratios: impl Iterator<Item = f64>) -> Option<f64> {
    Amplitude::from_period_ratio(mean(period_ratios)).ok().map(|amplitude| amplitude.radians())
}

#[cfg(test)]
mod tests {
    use super::typical_amplitude;
    use libration::pendulum::period_ratio;

    #[test]
    fn the_typical_amplitude_has_the_mean_period() {
        let amplitudes = [0.3, 1.0, 1.2];
        let mean = amplitudes.map(period_ratio).iter().sum::<f64>() / 3.0;
        let typical = typical_amplitude(amplitudes.map(period_ratio).into_iter()).unwrap();
        assert!((period_ratio(typical) - mean).abs() < 1e-14);
        assert_eq!(typical_amplitude(std::iter::empty()), None);
    }
}
