//! The times at which the growth of a deviation is measured.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use super::super::drive::drive_period;
use super::super::extent::Extent;
use super::super::structure::angles;
use super::LyapunovError;
use crate::taylor::{Cause, Effort, IntegrationError, Moment, System, integrate_stepwise};
use libration_numbers::expression::Equation;

/// The duration of a measurement, and the intervals at which the growth of a deviation is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    /// The time that passes before the measurement begins.
    pub transient: f64,
    /// The time after which the size of the deviation is reset to one.
    pub interval: f64,
    /// Number of intervals that are measured.
    pub intervals: usize,
}

impl Schedule {
    /// Intervals of about a period of the motion, such that a drive's period is a multiple of them, with a transient of a hundred intervals.
    ///
    /// # Errors
    /// A parameter without a value, a start that does not fit, or a motion that stops at once.
    pub fn natural(
        equation: &Equation,
        start: &Moment,
        intervals: usize,
        effort: &Effort,
    ) -> Result<Self, LyapunovError> {
        const TO_SETTLE: f64 = 100.0;
        let of_motion = period_of_motion(equation, start, effort)?;
        let interval =
            drive_period(equation).map_or(of_motion, |period| period / (period / of_motion).ceil().max(1.0));
        Ok(Self { transient: TO_SETTLE * interval, interval, intervals })
    }

    pub(super) fn is_possible(&self) -> bool {
        let finite = self.interval.is_finite() && (0.0..f64::INFINITY).contains(&self.transient);
        finite && self.interval > 0.0 && self.intervals > 0
    }
}

/// The approximate period of the fastest coordinate: 2π times half its width over its largest speed.
fn period_of_motion(equation: &Equation, start: &Moment, effort: &Effort) -> Result<f64, LyapunovError> {
    const STEPS: usize = 400;
    /// A time that only a motion without a force takes few steps to: others end by the number of steps, in all units.
    const LONG: f64 = 1e100;
    let system = System::new(equation)?;
    let effort = Effort { most_steps: STEPS, ..*effort };
    let mut extent = Extent::new(start.state.len());
    let mut speeds = Extent::new(system.coordinates());
    let end = start.time + LONG;
    let outcome = integrate_stepwise(&system, start, &[end], &effort, |step| {
        extent.include(&step.state_at(step.end()));
        speeds.include(&step.speeds_at(step.end()));
        ControlFlow::Continue(())
    });
    match outcome {
        Ok(_) | Err(IntegrationError::Stopped { cause: Cause::StepLimit, .. }) => {
            Ok(fastest_period(&extent, &speeds, equation))
        }
        Err(error) => Err(error.into()),
    }
}

/// The shortest period over the coordinates; one if nothing moves.
fn fastest_period(extent: &Extent, speeds: &Extent, equation: &Equation) -> f64 {
    let (widths, speeds) = (extent.units(&angles(equation)), speeds.sizes());
    let period = |(width, speed): (&f64, &f64)| 0.5 * TAU * width / speed;
    let periods = widths.iter().zip(&speeds).map(period);
    let fastest = periods.filter(|period| period.is_finite()).fold(f64::INFINITY, f64::min);
    if fastest.is_finite() { fastest } else { 1.0 }
}
