//! The pendulum: its length and gravity, with their defaults.

use super::text;
use crate::call;
use crate::output::field::{Field, Fields};
use crate::output::{json::Record, number};
use crate::query_error::QueryError;
use libration::pendulum::{Motion, Pendulum};
use libration::quantity::{Angle, Quantity, STANDARD_GRAVITY};

const DEFAULT_LENGTH: f64 = 1.0;

/// The options that describe the pendulum.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct PendulumOptions {
    /// Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m]
    #[arg(long, value_parser = text::length_with_uncertainty)]
    length: Option<Quantity>,
    /// Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default: 9.80665m/s^2]
    #[arg(long, value_parser = text::gravity_with_uncertainty)]
    gravity: Option<Quantity>,
}

impl PendulumOptions {
    pub(crate) fn length(self) -> f64 {
        self.length.map_or(DEFAULT_LENGTH, |length| length.value)
    }

    pub(crate) fn gravity(self) -> f64 {
        self.gravity.map_or(STANDARD_GRAVITY, |gravity| gravity.value)
    }

    /// Returns `true` if neither was given.
    pub(crate) fn is_default(self) -> bool {
        self.length.is_none() && self.gravity.is_none()
    }

    /// The pendulum, with a note on uncertainties, which are not used.
    pub(crate) fn pendulum(self) -> Result<Pendulum, QueryError> {
        for (name, given) in [("length", self.length), ("gravity", self.gravity)] {
            if given.is_some_and(|given| given.uncertainty.is_some()) {
                call::current()
                    .note(&format!("the uncertainty of the {name} is not used here, only its value"));
            }
        }
        self.exact()
    }

    /// The pendulum, and the relative uncertainty of its period of small swings.
    pub(crate) fn with_uncertainty(self) -> Result<(Pendulum, f64), QueryError> {
        let relative = |given: Option<Quantity>| {
            given.map_or(0.0, |given| given.uncertainty.unwrap_or(0.0) / given.value)
        };
        Ok((self.exact()?, 0.5 * relative(self.length).hypot(relative(self.gravity))))
    }

    fn exact(self) -> Result<Pendulum, QueryError> {
        Pendulum::new(self.length(), self.gravity()).map_err(|error| QueryError::no_result("pendulum", error))
    }

    /// The fields of the pendulum, in JSON and in lines of a sheet.
    pub(crate) fn fields() -> Fields<Self> {
        type Of = Field<PendulumOptions>;
        const GRAVITY: &str = "acceleration of free fall";
        Fields::from([
            Of::number("length_m", "m", "length of the pendulum", |options| options.length())
                .line_of("length", |options| {
                    format!("{} m{}", number::short(options.length(), 12), said(options.length))
                }),
            Of::number("gravity_m_per_s2", "m/s²", GRAVITY, |options| options.gravity())
                .line_of("gravity", |options| {
                    format!("{} m/s²{}", number::short(options.gravity(), 12), said(options.gravity))
                }),
        ])
    }

    pub(crate) fn lines(self) -> Vec<(&'static str, String)> {
        Self::fields().lines(&self)
    }

    pub(crate) fn record(self) -> Record {
        Self::fields().record(&self)
    }
}

fn said(given: Option<Quantity>) -> &'static str {
    if given.is_some() { "" } else { " (default)" }
}

/// The motion that starts at this angle with this velocity (rad/s).
pub(crate) fn motion(pendulum: &Pendulum, angle: Angle, velocity: f64) -> Result<Motion, QueryError> {
    pendulum.launched(angle, velocity).map_err(|error| QueryError::no_result("motion", error))
}
