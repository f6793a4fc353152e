//! Inverse problems: the amplitude for a given period; the length or the gravity from a measured period.

use super::{Amplitude, Pendulum, PendulumError, USABLE, positive};
use libration_kernels::double_double::{DoubleDouble, two_prod};
use libration_kernels::elementary::two_word;
use libration_numbers::quantity::{Angle, Quantity};

/// Step limit of Newton's iteration, which doubles the digits: from three digits four steps suffice, and the rest is margin.
const STEPS: usize = 8;
const LN_8: f64 = 3.0 * std::f64::consts::LN_2;

/// T/T0 − 1 above which the complement would be below 1e-300.
const LARGEST_EXCESS: f64 = 440.08;

impl Amplitude {
    /// The amplitude whose period ratio T/T0 is exactly this `f64`, at least 1; accurate to the last bits that the ratio determines.
    ///
    /// # Errors
    /// A ratio below 1, not finite, or above 441.08, where the complement is below 1e-300.
    pub fn from_period_ratio(ratio: f64) -> Result<Self, PendulumError> {
        // Exact below 2; above 2 the excess is not small.
        Self::from_excess(ratio - 1.0, ratio)
    }

    /// The amplitude whose excess T/T0 − 1 is exactly this `f64`.
    ///
    /// # Errors
    /// An excess that is negative, not finite, or too large, as for [`Self::from_period_ratio`].
    pub fn from_period_excess(excess: f64) -> Result<Self, PendulumError> {
        Self::from_excess(excess, 1.0 + excess)
    }

    /// Largest change of the amplitude, in radians, when its period changes by this fraction of itself in either direction; at least an ulp of
    /// the amplitude. A period below that of small swings counts as amplitude zero, and a period that is too long as amplitude π.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_pendulum as libration;
    /// use libration::pendulum::Amplitude;
    /// let amplitude = Amplitude::from_period_ratio(1.0732)?;
    /// assert!((amplitude.change_with_period(1e-3) - 0.0073).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn change_with_period(&self, fraction: f64) -> f64 {
        let (ratio, excess) = self.ratio_and_excess();
        let rounding = f64::EPSILON * self.radians().min(self.complement());
        let change = |fraction: f64| match Self::from_period_excess((excess + fraction * ratio).max(0.0)) {
            Ok(other) if self.complement() < 1.0 => (other.complement() - self.complement()).abs(),
            Ok(other) => (other.radians() - self.radians()).abs(),
            Err(_) => self.complement(),
        };
        [fraction, -fraction].into_iter().map(change).fold(rounding, f64::max)
    }

    fn from_excess(excess: f64, ratio: f64) -> Result<Self, PendulumError> {
        if !(0.0..f64::INFINITY).contains(&excess) {
            return Err(PendulumError::NoSuchPeriod(ratio));
        }
        if excess > LARGEST_EXCESS {
            return Err(PendulumError::PeriodTooLong(ratio));
        }
        Ok(if excess < 0.18 { below(excess) } else { near_top(excess) })
    }
}

/// Newton's method for ln(excess) as a function of ln(amplitude), from excess = θ0²/16.
fn below(excess: f64) -> Amplitude {
    let mut angle = 4.0 * excess.sqrt();
    let of = |angle: f64| Amplitude { angle: Angle::from_radians(angle).expect("an angle below pi") };
    for _ in 0..STEPS {
        let amplitude = of(angle);
        let (period_excess, slope) =
            (amplitude.period_excess(), amplitude.condition() * amplitude.period_ratio());
        // Below 1e-150 the excess is θ0²/16, so that the initial guess is exact.
        if slope < f64::MIN_POSITIVE {
            break;
        }
        angle -= angle * (period_excess - excess) / slope;
    }
    of(angle)
}

/// Newton's method for T/T0 as a function of the logarithm of the complement, from 8e^(−πR/2).
fn near_top(excess: f64) -> Amplitude {
    // The logarithm has two words: one word would not resolve the last bits of a large ratio.
    let mut log = DoubleDouble::from(LN_8 - std::f64::consts::FRAC_PI_2 * (1.0 + excess));
    let of = |log: DoubleDouble| Amplitude { angle: Angle::from_complement_words(two_word::exp(log)) };
    for _ in 0..STEPS {
        let amplitude = of(log);
        let slope =
            -amplitude.logarithmic_slope().to_f64() * amplitude.complement() * amplitude.period_ratio();
        log = log - (amplitude.period_excess() - excess) / slope;
    }
    of(log)
}

/// Largest relative rounding error of an `f64`.
const HALF_ULP: f64 = f64::EPSILON / 2.0;

/// An amplitude inferred from a period, with its uncertainty: that of the period propagated, at least its rounding error.
///
/// # Examples
/// ```
/// # extern crate libration_pendulum as libration;
/// use libration::pendulum::{InferredAmplitude, Pendulum};
/// use libration::quantity::{Dimension, parse};
/// let period = parse("2.10(1) s", Dimension::Time)?;
/// let inferred = InferredAmplitude::from_period(&period, &Pendulum::new(1.0, 9.80665)?, 0.0)?;
/// assert!((inferred.amplitude.radians() - 0.846).abs() < 1e-3 && (inferred.uncertainty - 0.045).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InferredAmplitude {
    /// The amplitude.
    pub amplitude: Amplitude,
    /// Standard uncertainty of the amplitude, in radians.
    pub uncertainty: f64,
}

impl InferredAmplitude {
    /// The amplitude with this period, in seconds, of a pendulum; `of_small_swings` is the relative uncertainty of its period of small swings.
    ///
    /// # Errors
    /// A period shorter than that of small swings by more than the uncertainty, or one rejected by [`Amplitude::from_period_ratio`].
    pub fn from_period(
        period: &Quantity,
        pendulum: &Pendulum,
        of_small_swings: f64,
    ) -> Result<Self, PendulumError> {
        let small = pendulum.small_angle_period();
        // Two roundings besides that of the text: one of the period of small swings, one of the quotient.
        let relative = libm::hypot(of_number(period) / period.value, of_small_swings) + 2.0 * HALF_ULP;
        let ratio = period.value / small;
        Self::within(ratio - 1.0, ratio * relative).map_err(|error| match error {
            PendulumError::NoSuchPeriod(_) => {
                PendulumError::ShorterThanSmallSwings { period: period.value, small }
            }
            error => error,
        })
    }

    /// The amplitude with this ratio T/T0.
    ///
    /// # Errors
    /// A ratio below 1 by more than its uncertainty, or one rejected by [`Amplitude::from_period_ratio`].
    pub fn from_ratio(ratio: &Quantity) -> Result<Self, PendulumError> {
        // Exact below 2; above 2 the excess is not small.
        Self::within(ratio.value - 1.0, of_number(ratio))
    }

    /// The amplitude with this excess T/T0 − 1.
    ///
    /// # Errors
    /// An excess below 0 by more than its uncertainty, or one rejected by [`Amplitude::from_period_excess`].
    pub fn from_excess(excess: &Quantity) -> Result<Self, PendulumError> {
        Self::within(excess.value, of_number(excess))
    }

    /// The amplitude of an excess; a negative excess within the uncertainty counts as 0.
    fn within(excess: f64, uncertainty: f64) -> Result<Self, PendulumError> {
        let nearest = if excess < 0.0 && excess >= -uncertainty { 0.0 } else { excess };
        let amplitude = Amplitude::from_period_excess(nearest)?;
        let uncertainty = amplitude.change_with_period(uncertainty / amplitude.period_ratio());
        Ok(Self { amplitude, uncertainty })
    }
}

/// The uncertainty of a number as written: the stated one, at least the rounding error.
fn of_number(number: &Quantity) -> f64 {
    number.uncertainty.unwrap_or(0.0).max(HALF_ULP * number.value.abs())
}

impl Pendulum {
    /// The pendulum of this length in metres whose libration with this amplitude has this period in seconds; the gravity is 4π²l(T/T0)²/T².
    ///
    /// # Errors
    /// A length or period that is not positive and finite, or whose angular frequency or gravity is outside the
    /// range of `f64`.
    pub fn from_length_and_period(
        length: f64,
        period: f64,
        amplitude: &Amplitude,
    ) -> Result<Self, PendulumError> {
        positive("length", length)?;
        positive("period", period)?;
        let frequency = frequency_of(period, amplitude)?;
        // In this order every intermediate result lies between the length and the gravity.
        let gravity = (frequency * length * frequency).to_f64();
        if !gravity.is_normal() {
            return Err(PendulumError::Unattainable { name: "gravity", period });
        }
        Self::new(length, gravity)
    }

    /// The pendulum under this gravity in m/s² whose libration with this amplitude has this period in seconds; the length is gT²/(4π²(T/T0)²).
    ///
    /// # Errors
    /// A gravity or period that is not positive and finite, or whose angular frequency or length is outside the
    /// range of `f64`.
    pub fn from_gravity_and_period(
        gravity: f64,
        period: f64,
        amplitude: &Amplitude,
    ) -> Result<Self, PendulumError> {
        positive("gravity", gravity)?;
        positive("period", period)?;
        let frequency = frequency_of(period, amplitude)?;
        let length = (DoubleDouble::from(gravity) / frequency / frequency).to_f64();
        if !length.is_normal() {
            return Err(PendulumError::Unattainable { name: "length", period });
        }
        Self::new(length, gravity)
    }
}

/// ω0 = 2πR/T.
fn frequency_of(period: f64, amplitude: &Amplitude) -> Result<DoubleDouble, PendulumError> {
    let turns = two_prod(2.0, amplitude.period_ratio());
    let frequency = DoubleDouble::PI * turns / DoubleDouble::from(period);
    if USABLE.contains(&frequency.hi) { Ok(frequency) } else { Err(PendulumError::PeriodOutOfRange(period)) }
}
