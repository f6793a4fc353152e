//! The spectrum of a motion: the amplitude at each frequency of values at evenly spaced times.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::pendulum::Pendulum;
//! use libration::spectrum::Spectrum;
//!
//! // A pendulum from 120°, over 30 periods: its lines are the harmonics 1, 3, 5, …
//! let motion = Pendulum::from_angular_frequency(1.0)?.released_from("120deg".parse()?)?;
//! let interval = 30.0 * motion.period() / 4096.0;
//! let angles: Vec<f64> = (0..4096_u32).map(|n| motion.state_at(interval * f64::from(n)).angle).collect();
//! let spectrum = Spectrum::new(&angles, interval)?;
//! let third = 3.0 * std::f64::consts::TAU / motion.period();
//! assert!((spectrum.amplitude_at(third) - motion.harmonics(1e-9, 10).terms[1].angle.abs()).abs() < 1e-7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[doc(hidden)]
pub(crate) mod fourier;
#[doc(hidden)]
pub(crate) mod window;

use crate::taylor::DenseSolution;
use libration_numbers::algebra::Complex;
use std::f64::consts::TAU;

/// The amplitude of the oscillations of each frequency in a motion.
///
/// The values are weighted by Kaiser's window (Kaiser and Schafer, IEEE Trans. ASSP 28, 105, 1980), so that an oscillation
/// a·cos(ωt + φ) makes a line of height a and half-width [`Self::resolution`], and beyond the line less than
/// [`Self::SIDE_LOBES`] times a. Oscillations nearer to each other, or to frequency zero, are not distinguished. A mean value is
/// the height at zero. A quantity that grows without bound, such as the angle of a rotation, has no spectrum: take its velocity.
#[derive(Clone, Debug)]
pub struct Spectrum {
    weighted: Vec<f64>,
    interval: f64,
    amplitudes: Vec<f64>,
}

/// The reason why there is no spectrum.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// Too few values.
    #[error("{0} values are too few for a spectrum: give at least {least}", least = Spectrum::FEWEST)]
    TooFew(usize),
    /// A value that is infinite or not a number.
    #[error("{0:?} is among the values: a spectrum needs finite ones")]
    NotFinite(f64),
    /// An interval of time that is not above zero.
    #[error("the interval between the values is {0:?} s: give one above zero")]
    Interval(f64),
    /// Times at which the motion is not known.
    #[error(
        "the motion is not known from {from:?} s to {until:?} s: give times within it, the earlier one first"
    )]
    NotKnown {
        /// The first requested time, in seconds.
        from: f64,
        /// The last requested time, in seconds.
        until: f64,
    },
    /// Values that drift from one end to the other more than they oscillate, such as the angle of a rotation.
    #[error(
        "the values go from {first:?} to {last:?} and swing little about that: take their rate of change"
    )]
    Trend {
        /// The first value.
        first: f64,
        /// The last value.
        last: f64,
    },
    /// Oscillations faster than the values can resolve.
    #[error("{0} values do not show the fastest oscillations: give a shorter time")]
    NotResolved(usize),
}

impl Spectrum {
    /// The relative height of a line far from its middle: the side lobes of the window.
    pub const SIDE_LOBES: f64 = 2e-8;

    /// Minimum number of values of a spectrum.
    pub const FEWEST: usize = 16;

    /// Maximum number of values taken from a motion.
    pub const MOST: usize = 1 << 20;

    /// The spectrum of values at intervals of `interval` seconds.
    ///
    /// # Errors
    /// Too few values, a value that is not finite, an interval that is not above zero.
    pub fn new(values: &[f64], interval: f64) -> Result<Self, SpectrumError> {
        if values.len() < Self::FEWEST {
            return Err(SpectrumError::TooFew(values.len()));
        }
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            return Err(SpectrumError::NotFinite(*value));
        }
        if !(interval > 0.0 && interval.is_finite()) {
            return Err(SpectrumError::Interval(interval));
        }
        let weighted = window::weighted(values);
        let transform = fourier::transform(&padded(&weighted));
        let amplitudes = transform[..=transform.len() / 2].iter().map(|z| 2.0 * z.abs()).collect::<Vec<_>>();
        Ok(Self { weighted, interval, amplitudes: halved_at_zero(amplitudes) })
    }

    /// The spectrum of one state component (a coordinate or, after these, a velocity) of a motion
    /// between two times, from as many values as necessary: at least two for each step of the
    /// integration, doubled until the amplitudes at the highest frequencies are no more than side lobes.
    ///
    /// # Errors
    /// Times outside the motion, values that grow, or that oscillate too fast for [`Self::MOST`] values.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::spectrum::Spectrum;
    /// use libration::taylor::{Effort, System, integrate_dense};
    /// let system = System::new(&"theta'' + sin(theta) = 0".parse()?)?;
    /// // Fast enough to turn over: the angle grows, but its velocity oscillates.
    /// let start = system.start(&[("theta'", 3.0)])?;
    /// let motion = integrate_dense(&system, &start, 100.0, &Effort::to_tolerance(1e-12))?;
    /// assert!(Spectrum::of_motion(&motion, 0, [0.0, 100.0]).is_err());
    /// assert!(Spectrum::of_motion(&motion, 1, [0.0, 100.0]).is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_motion(
        motion: &DenseSolution,
        number: usize,
        [from, until]: [f64; 2],
    ) -> Result<Self, SpectrumError> {
        let mut count = (2 * motion.steps().len()).clamp(FEWEST_OF_MOTION, Self::MOST);
        loop {
            let interval = (until - from) / float(count - 1);
            // The last time is the given one, not a sum with rounding errors.
            let time = |index: usize| if index + 1 == count { until } else { from + interval * float(index) };
            let value = |index| motion.state_at(time(index))?.get(number).copied();
            let values: Option<Vec<f64>> = (0..count).map(value).collect();
            let values = values.filter(|_| from < until).ok_or(SpectrumError::NotKnown { from, until })?;
            check_trend(&values)?;
            let spectrum = Self::new(&values, interval)?;
            if spectrum.is_resolved() {
                return Ok(spectrum);
            }
            count *= 2;
            if count > Self::MOST {
                return Err(SpectrumError::NotResolved(values.len()));
            }
        }
    }

    /// Returns `true` if the amplitudes have fallen to the level of the side lobes before the last eighth of the frequencies.
    fn is_resolved(&self) -> bool {
        let largest = |amplitudes: &[f64]| amplitudes.iter().copied().fold(0.0, f64::max);
        let (lower, highest) = self.amplitudes.split_at(self.amplitudes.len() / 8 * 7);
        largest(highest) <= 2.0 * Self::SIDE_LOBES * largest(lower)
    }

    /// Angular frequencies (in rad/s, from zero to the highest one that the values resolve)
    /// and amplitudes (in the unit of the values), at least 50 points per width of a line.
    pub fn points(&self) -> impl ExactSizeIterator<Item = (f64, f64)> + '_ {
        let step = self.highest() / float(self.amplitudes.len() - 1);
        self.amplitudes.iter().enumerate().map(move |(index, amplitude)| (step * float(index), *amplitude))
    }

    /// The amplitude at an angular frequency (rad/s) above zero.
    ///
    /// # Accuracy
    /// At the frequency of an oscillation its amplitude, to [`Self::SIDE_LOBES`] times the sum of all amplitudes.
    #[must_use]
    pub fn amplitude_at(&self, angular_frequency: f64) -> f64 {
        let turn = angular_frequency * self.interval;
        let terms = self.weighted.iter().enumerate();
        let sum = terms
            .fold(Complex::default(), |sum, (n, value)| sum + Complex::unit(-turn * float(n)).scaled(*value));
        2.0 * sum.abs()
    }

    /// The highest angular frequency that the values resolve, in rad/s: half a turn per interval. Faster oscillations appear as slower ones.
    #[must_use]
    pub fn highest(&self) -> f64 {
        0.5 * TAU / self.interval
    }

    /// The half-width of a line, in rad/s.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        window::half_width() * TAU / (self.interval * float(self.weighted.len()))
    }
}

/// Minimum number of values of a motion: fewer would give a spectrum of few points.
const FEWEST_OF_MOTION: usize = 4096;

/// Rejects values whose departure from the line between their ends is less than half of the difference of the ends. A function that oscillates
/// about a mean, with any phases at its ends, departs by at least as much.
fn check_trend(values: &[f64]) -> Result<(), SpectrumError> {
    let (Some(&first), Some(&last)) = (values.first(), values.last()) else { return Ok(()) };
    let slope = (last - first) / float(values.len() - 1);
    let departures = values.iter().enumerate().map(|(index, value)| value - first - slope * float(index));
    let (low, high) = departures
        .fold((0.0, 0.0), |(low, high): (f64, f64), departure| (low.min(departure), high.max(departure)));
    if high - low < 0.5 * (last - first).abs() { Err(SpectrumError::Trend { first, last }) } else { Ok(()) }
}

/// Halves the amplitude at zero, since a mean value is its own mirror image.
fn halved_at_zero(mut amplitudes: Vec<f64>) -> Vec<f64> {
    if let Some(mean) = amplitudes.first_mut() {
        *mean *= 0.5;
    }
    amplitudes
}

/// The values padded with zeros, to a power of two that is at least twice their number: a line has a half-width of six steps of the plain
/// transform, and loses less than 0.4 % of its height at the points next to its middle.
fn padded(values: &[f64]) -> Vec<Complex> {
    let mut padded: Vec<Complex> = values.iter().map(|value| Complex::from(*value)).collect();
    padded.resize((4 * values.len()).next_power_of_two(), Complex::default());
    padded
}

#[expect(clippy::cast_precision_loss, reason = "numbers of values, far below 2^53")]
fn float(number: usize) -> f64 {
    number as f64
}
