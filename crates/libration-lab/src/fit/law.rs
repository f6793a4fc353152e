//! A law of the period: T/T0 as a function of the amplitude, and its slope.

use std::fmt;

use super::error::FitError;
use super::period_table::Row;
use libration::pendulum::period_ratio;

/// Step of the central difference, relative to the distance from 0 or π: the error is then about 1e-8 of the
/// slope, which only enters the weights.
const RELATIVE_STEP: f64 = 1e-4;
/// Amplitude below which the step is that of this amplitude, so that R does not vanish in its rounding.
const SMALL_AMPLITUDE: f64 = 0.05;

/// T/T0 as a function of the amplitude, under a name.
#[derive(Clone, Copy)]
pub struct Law<'a> {
    key: &'a str,
    ratio: &'a dyn Fn(f64) -> f64,
}

impl fmt::Debug for Law<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law").field("key", &self.key).finish_non_exhaustive()
    }
}

impl<'a> Law<'a> {
    /// The law of this key with this T/T0, a function of the amplitude in radians.
    #[must_use]
    pub fn new(key: &'a str, ratio: &'a dyn Fn(f64) -> f64) -> Self {
        Self { key, ratio }
    }

    /// The exact law, `exact`.
    #[must_use]
    pub fn exact() -> Law<'static> {
        Law { key: "exact", ratio: &period_ratio }
    }

    /// The same period at every amplitude, `constant`.
    #[must_use]
    pub fn constant() -> Law<'static> {
        Law { key: "constant", ratio: &|_| 1.0 }
    }

    /// The name of the law.
    #[must_use]
    pub fn key(&self) -> &'a str {
        self.key
    }

    /// T/T0 at this amplitude in radians.
    #[must_use]
    pub fn ratio_at(&self, amplitude: f64) -> f64 {
        (self.ratio)(amplitude)
    }

    /// The derivative of T/T0 with respect to the amplitude, by a central difference; zero where the law has
    /// no finite value next to the amplitude.
    #[must_use]
    pub fn slope_at(&self, amplitude: f64) -> f64 {
        let step = RELATIVE_STEP * amplitude.max(SMALL_AMPLITUDE).min(std::f64::consts::PI - amplitude);
        let (above, below) = (amplitude + step, (amplitude - step).abs());
        let rise = self.ratio_at(above) - self.ratio_at(below);
        if rise.is_finite() { rise / (above - (amplitude - step)) } else { 0.0 }
    }

    /// R and R′ of every row.
    #[doc(hidden)]
    pub fn points(&self, rows: &[Row]) -> Result<Vec<Point>, FitError> {
        let point = |row: &Row| {
            let ratio = self.ratio_at(row.amplitude);
            if !(ratio > 0.0 && ratio.is_finite()) {
                return Err(FitError::LawUndefined { key: self.key.into(), amplitude: row.amplitude });
            }
            let slope = if row.amplitude_uncertainty > 0.0 { self.slope_at(row.amplitude) } else { 0.0 };
            Ok(Point { row: *row, ratio, slope })
        };
        rows.iter().map(point).collect()
    }
}

/// A row with the law at its amplitude.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub(super) row: Row,
    pub(super) ratio: f64,
    slope: f64,
}

impl Point {
    /// The effective variance if T changes by `scale`·R′ with the amplitude; zero without weights.
    pub fn variance(&self, scale: f64) -> f64 {
        let from_amplitude = scale * self.slope * self.row.amplitude_uncertainty;
        self.row.period_uncertainty * self.row.period_uncertainty + from_amplitude * from_amplitude
    }
}
