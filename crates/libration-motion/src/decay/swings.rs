//! Integration of a damped motion from turning point to turning point.
//!
//! # Method
//! Between turning points the velocity has one sign, so that each swing is one analytic piece, mirrored for downward motion; from above a right
//! angle it is integrated from the top (`half_swing.rs`). If a power of the velocity is not an integer, rest has no Taylor series: next to rest
//! gravity is constant to 1e-10, and time and distance are integrals (`turning.rs`). Averaged laws are autonomous, so that they give the time as
//! an integral over ln tan(A/2), analytic from the bottom to the top, which is inverted (`envelope.rs`).

use super::ending::DecayEnding;
use super::half_swing::{HalfSwing, Turn};
use super::{Decay, DecayError};
use crate::taylor::IntegrationError;
use libration_kernels::double_double::DoubleDouble;
use libration_pendulum::pendulum::Amplitude;

/// A turning point of the pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningPoint {
    /// The time, in seconds after the release.
    pub time: f64,
    /// The angle from the bottom. The first, third, fifth, … turning point is on the side of the release.
    pub amplitude: Amplitude,
}

/// The turning points of a damped pendulum, in chronological order; see [`Decay::swings`]. The sequence ends after an error.
///
/// # Accuracy
/// Each swing has an error of about 1e-15 of ω0t and of its initial amplitude, or 1e-13 for powers of
/// the velocity that are not integers. Above a right angle an amplitude is accurate to 1e-15 of π.
#[derive(Clone, Debug)]
pub struct Swings<'a> {
    decay: &'a Decay,
    swing: HalfSwing,
    /// The time in units of 1/ω0.
    time: DoubleDouble,
    /// `None` before the start.
    amplitude: Option<Amplitude>,
    ended: Option<Result<DecayEnding, ()>>,
}

impl<'a> Swings<'a> {
    pub(super) fn new(decay: &'a Decay) -> Self {
        let swing = HalfSwing::new(&decay.scaled);
        Self { decay, swing, time: DoubleDouble::ZERO, amplitude: None, ended: None }
    }

    /// The reason why the turning points end; `None` as long as there may be another one, and after an error.
    #[must_use]
    pub fn ending(&self) -> Option<DecayEnding> {
        self.ended.and_then(Result::ok)
    }

    /// Seconds from the release to this time after the last turning point.
    fn seconds_after(&self, duration: f64) -> f64 {
        ((self.time + duration) / DoubleDouble::from(self.decay.pendulum.angular_frequency())).to_f64()
    }

    /// The turning point after the last one, or the reason why there is none.
    fn following(&self) -> Result<Turn, IntegrationError> {
        self.amplitude.map_or(Ok(Ok((0.0, self.decay.start))), |amplitude| self.swing.after(&amplitude))
    }
}

impl Iterator for Swings<'_> {
    type Item = Result<TurningPoint, DecayError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended.is_some() {
            return None;
        }
        match self.following() {
            Ok(Ok((duration, amplitude))) => {
                let time = self.seconds_after(duration);
                self.time = self.time + duration;
                self.amplitude = Some(amplitude);
                Some(Ok(TurningPoint { time, amplitude }))
            }
            Ok(Err(ending)) => {
                self.ended = Some(Ok(match ending {
                    DecayEnding::StopsOnTheWay { time, angle } => {
                        DecayEnding::StopsOnTheWay { time: self.seconds_after(time), angle }
                    }
                    other => other,
                }));
                None
            }
            Err(error) => {
                self.ended = Some(Err(()));
                Some(Err(error.into()))
            }
        }
    }
}
