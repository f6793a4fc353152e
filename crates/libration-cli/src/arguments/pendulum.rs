//! The pendulum: its length and gravity, with their defaults.

use super::text;
use crate::failure::Failure;
use crate::output::{json::Record, number};
use libration::pendulum::{Motion, Pendulum};
use libration::quantity::{Angle, STANDARD_GRAVITY};

const DEFAULT_LENGTH: f64 = 1.0;

/// The options that describe the pendulum.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct PendulumOptions {
    /// Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m]
    #[arg(long, value_parser = text::length)]
    length: Option<f64>,
    /// Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default: 9.80665m/s^2]
    #[arg(long, value_parser = text::gravity)]
    gravity: Option<f64>,
}

impl PendulumOptions {
    pub(crate) fn length(self) -> f64 {
        self.length.unwrap_or(DEFAULT_LENGTH)
    }

    pub(crate) fn gravity(self) -> f64 {
        self.gravity.unwrap_or(STANDARD_GRAVITY)
    }

    /// Whether neither was given.
    pub(crate) fn is_default(self) -> bool {
        self.length.is_none() && self.gravity.is_none()
    }

    pub(crate) fn pendulum(self) -> Result<Pendulum, Failure> {
        Pendulum::new(self.length(), self.gravity()).map_err(|error| Failure::no_answer("pendulum", error))
    }

    /// The lines of a sheet that say which pendulum was meant.
    pub(crate) fn lines(self) -> [(&'static str, String); 2] {
        let said = |given: Option<f64>| if given.is_some() { "" } else { " (default)" };
        [
            ("length", format!("{} m{}", number::short(self.length(), 12), said(self.length))),
            ("gravity", format!("{} m/s²{}", number::short(self.gravity(), 12), said(self.gravity))),
        ]
    }

    pub(crate) fn record(self) -> Record {
        Record::new().number("length_m", self.length()).number("gravity_m_per_s2", self.gravity())
    }
}

/// The motion that starts at this angle with this velocity (rad/s).
pub(crate) fn motion(pendulum: &Pendulum, angle: Angle, velocity: f64) -> Result<Motion, Failure> {
    pendulum.launched(angle, velocity).map_err(|error| Failure::no_answer("motion", error))
}
