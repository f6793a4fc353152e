//! The timed passes, each including the set-up that a user would need.

use libration::pendulum::{self, LengthMismatch, Motion, Pendulum, PendulumError};
use libration::quantity::{Angle, QuantityError};
use std::io;
use std::num::{ParseFloatError, ParseIntError};
use std::time::{Duration, Instant};

/// The arrays in use; results overwrite the previous ones, as with NumPy's `out=`.
#[derive(Default)]
pub(crate) struct Work {
    pub(crate) amplitudes: Vec<f64>,
    pub(crate) times: Vec<f64>,
    pub(crate) parameters: Vec<f64>,
    pub(crate) angles: Vec<f64>,
    pub(crate) velocities: Vec<f64>,
    pub(crate) others: [Vec<f64>; 2],
}

/// Reason why a request failed.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error("unknown request `{0}`")]
    Request(String),
    #[error(transparent)]
    Stream(#[from] io::Error),
    #[error(transparent)]
    Count(#[from] ParseIntError),
    #[error(transparent)]
    Number(#[from] ParseFloatError),
    #[error(transparent)]
    Angle(#[from] QuantityError),
    #[error(transparent)]
    Pendulum(#[from] PendulumError),
    #[error(transparent)]
    Lengths(#[from] LengthMismatch),
}

impl Work {
    /// T/T0 of every amplitude.
    pub(crate) fn period(&mut self) -> Result<Duration, Failure> {
        self.angles.resize(self.amplitudes.len(), 0.0);
        let start = Instant::now();
        pendulum::period_ratios(&self.amplitudes, &mut self.angles)?;
        Ok(start.elapsed())
    }

    /// The states at every time of one motion released from rest.
    pub(crate) fn motion(&mut self, amplitude: f64) -> Result<Duration, Failure> {
        self.resize(self.times.len());
        let start = Instant::now();
        released_from(amplitude)?.states_at(&self.times, &mut self.angles, &mut self.velocities)?;
        Ok(start.elapsed())
    }

    /// The states at every time of one motion prepared for many times.
    pub(crate) fn prepared(&mut self, amplitude: f64) -> Result<Duration, Failure> {
        self.resize(self.times.len());
        let start = Instant::now();
        released_from(amplitude)?.prepare().states_at(&self.times, &mut self.angles, &mut self.velocities)?;
        Ok(start.elapsed())
    }

    /// The states at every pair of amplitude and time.
    pub(crate) fn varying(&mut self) -> Result<Duration, Failure> {
        self.resize(self.times.len());
        let start = Instant::now();
        let (angles, velocities) = (&mut self.angles, &mut self.velocities);
        pendulum::states(&self.amplitudes, 1.0, &self.times, angles, velocities)?;
        Ok(start.elapsed())
    }

    fn resize(&mut self, count: usize) {
        self.angles.resize(count, 0.0);
        self.velocities.resize(count, 0.0);
    }
}

fn released_from(amplitude: f64) -> Result<Motion, Failure> {
    Ok(Pendulum::from_angular_frequency(1.0)?.released_from(Angle::from_radians(amplitude)?)?)
}
