//! The spectrum of a motion: how much of each frequency is in values at evenly spaced times.
//!
//! ```
//! use libration::pendulum::Pendulum;
//! use libration::spectrum::Spectrum;
//!
//! // A pendulum from 120°, over 30 periods: the harmonics 1, 3, 5, … stand out.
//! let motion = Pendulum::from_angular_frequency(1.0)?.released_from("120deg".parse()?)?;
//! let interval = 30.0 * motion.period() / 4096.0;
//! let angles: Vec<f64> = (0..4096_u32).map(|n| motion.state_at(interval * f64::from(n)).angle).collect();
//! let spectrum = Spectrum::new(&angles, interval)?;
//! let third = 3.0 * std::f64::consts::TAU / motion.period();
//! assert!((spectrum.amplitude_at(third) - motion.harmonics(1e-9, 10).terms[1].angle.abs()).abs() < 1e-7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod fourier;
mod window;

use crate::algebra::Complex;
use std::f64::consts::TAU;

/// The amplitude of the oscillations of each frequency in a motion.
///
/// The values are weighted by Kaiser's window (Kaiser and Schafer, IEEE Trans. ASSP 28, 105, 1980), so that an oscillation
/// a·cos(ωt + φ) makes a line of height a, as wide as [`Self::resolution`] says, and beyond it less than
/// [`Self::SIDE_LOBES`] times a. Oscillations nearer to each other, or to frequency zero, are not told apart. A mean value is the
/// height at zero. What grows without bound, such as the angle of a rotation, has no spectrum: take its velocity.
#[derive(Clone, Debug)]
pub struct Spectrum {
    weighted: Vec<f64>,
    interval: f64,
    amplitudes: Vec<f64>,
}

/// Why there is no spectrum.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoSpectrum {
    /// Hardly any values.
    #[error("{0} values are too few for a spectrum: give at least {least}", least = Spectrum::FEWEST)]
    TooFew(usize),
    /// A value that is infinite or no number.
    #[error("{0:?} is among the values: a spectrum needs finite ones")]
    NotFinite(f64),
    /// An interval of time that cannot be.
    #[error("the interval between the values is {0:?} s: give one above zero")]
    Interval(f64),
}

impl Spectrum {
    /// What a line leaves of its height far from it: the side lobes of the window.
    pub const SIDE_LOBES: f64 = 2e-8;

    /// Fewer values have no spectrum.
    pub const FEWEST: usize = 16;

    /// The spectrum of values at times `interval` (in seconds) from each other.
    ///
    /// # Errors
    /// Too few values, a value that is not finite, an interval that is not above zero.
    pub fn new(values: &[f64], interval: f64) -> Result<Self, NoSpectrum> {
        if values.len() < Self::FEWEST {
            return Err(NoSpectrum::TooFew(values.len()));
        }
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            return Err(NoSpectrum::NotFinite(*value));
        }
        if !(interval > 0.0 && interval.is_finite()) {
            return Err(NoSpectrum::Interval(interval));
        }
        let weighted = window::weighted(values);
        let transform = fourier::transform(&padded(&weighted));
        let amplitudes = transform[..=transform.len() / 2].iter().map(|z| 2.0 * z.abs()).collect::<Vec<_>>();
        Ok(Self { weighted, interval, amplitudes: halved_at_zero(amplitudes) })
    }

    /// Angular frequencies (in rad/s, from zero to the highest that the values show) and amplitudes (in the unit of the values),
    /// at least 50 to the width of a line.
    pub fn points(&self) -> impl ExactSizeIterator<Item = (f64, f64)> + '_ {
        let step = self.highest() / float(self.amplitudes.len() - 1);
        self.amplitudes.iter().enumerate().map(move |(place, amplitude)| (step * float(place), *amplitude))
    }

    /// The amplitude at an angular frequency (rad/s) above zero.
    ///
    /// # Accuracy
    /// At the frequency of an oscillation its amplitude, to [`Self::SIDE_LOBES`] times the sum of the others' and of its own.
    #[must_use]
    pub fn amplitude_at(&self, angular_frequency: f64) -> f64 {
        let turn = angular_frequency * self.interval;
        let terms = self.weighted.iter().enumerate();
        let sum = terms
            .fold(Complex::default(), |sum, (n, value)| sum + Complex::unit(-turn * float(n)).scaled(*value));
        2.0 * sum.abs()
    }

    /// The highest angular frequency that the values show, in rad/s: half a turn from value to value. Faster oscillations appear at
    /// slower ones.
    #[must_use]
    pub fn highest(&self) -> f64 {
        0.5 * TAU / self.interval
    }

    /// How far from its middle a line ends, in rad/s.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        window::half_width() * TAU / (self.interval * float(self.weighted.len()))
    }
}

/// A mean value is its own mirror image.
fn halved_at_zero(mut amplitudes: Vec<f64>) -> Vec<f64> {
    if let Some(mean) = amplitudes.first_mut() {
        *mean *= 0.5;
    }
    amplitudes
}

/// With zeros behind, to a power of two that is at least twice as long: a line has a half-width of six steps of the
/// plain transform, and loses less than 0.4 % of its height at the points beside its middle.
fn padded(values: &[f64]) -> Vec<Complex> {
    let mut padded: Vec<Complex> = values.iter().map(|value| Complex::from(*value)).collect();
    padded.resize((4 * values.len()).next_power_of_two(), Complex::default());
    padded
}

#[expect(clippy::cast_precision_loss, reason = "numbers of values, far below 2^53")]
fn float(number: usize) -> f64 {
    number as f64
}

#[cfg(test)]
mod tests;
