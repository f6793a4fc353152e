//! A measured swing with the fitted motion: data, residuals, periods and amplitudes.

pub(crate) mod curve;
mod cycles;
mod data;
mod residuals;
pub(crate) mod thinned;

pub(crate) use cycles::{Envelope, Swings, amplitudes, periods};
pub(crate) use data::{is_long, stretches, whole};
pub(crate) use residuals::residuals;

use libration_lab::fit::trace::FittedTrace;
use libration_lab::measurement::{Observable, Trace};

/// A trace and the motion fitted to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fitted<'a> {
    pub(crate) trace: &'a Trace,
    pub(crate) fitted: &'a FittedTrace,
    /// The period of small swings, in seconds.
    pub(crate) small_angle_period: f64,
}

impl Fitted<'_> {
    /// Degrees for angles.
    fn shown(&self, value: f64) -> f64 {
        match self.trace.observable() {
            Observable::Angle => value.to_degrees(),
            Observable::AngularVelocity => value,
        }
    }

    fn label(&self) -> String {
        format!("{} / {}", self.symbol(), self.unit())
    }

    fn symbol(&self) -> &'static str {
        match self.trace.observable() {
            Observable::Angle => "angle θ",
            Observable::AngularVelocity => "velocity θ′",
        }
    }

    fn unit(&self) -> &'static str {
        match self.trace.observable() {
            Observable::Angle => "degrees",
            Observable::AngularVelocity => "(rad/s)",
        }
    }
}
