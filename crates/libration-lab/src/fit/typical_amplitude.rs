//! One amplitude that represents many.

use crate::statistics::mean;
use libration::pendulum::Amplitude;

/// The amplitude, in radians, whose T/T0 is the mean of these; `None` if there are none.
pub fn typical_amplitude(period_ratios: impl Iterator<Item = f64>) -> Option<f64> {
    Amplitude::from_period_ratio(mean(period_ratios)).ok().map(|amplitude| amplitude.radians())
}
