//! Derivatives of time and state at the end of a motion with respect to the state there, for an end at an event or at a given time.

use super::crossing::{Crossing, Passing};
use super::survey::Survey;
use crate::taylor::program::linearised::ROUNDING;
use crate::taylor::{Moment, System};

/// The components of the state at the end and then its time, as results of a survey.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Outcome {
    /// Derivatives of each result with respect to the state at that time.
    pub(in crate::taylor) slopes: Vec<Vec<f64>>,
    /// Rounding errors added at the end itself.
    pub(in crate::taylor) end_errors: Vec<f64>,
}

impl Outcome {
    /// The outcome of a survey; `None` if the formula of the event has no derivatives.
    pub(in crate::taylor) fn new(system: &System, survey: &Survey) -> Option<Self> {
        let end = &survey.solution.end;
        let Some(event) = &survey.ending else { return Some(Self::at_given_time(end)) };
        let mut formulas = Crossing::all(system, event);
        let zero = Crossing::zero_at(&mut formulas, end, &survey.sizes, 0.0)?;
        let passing = formulas[zero].passing(end, &survey.sizes);
        let late = (passing.error / passing.rate).abs();
        let enclosing = formulas[zero].enclosing_time(end, &survey.sizes, late, |_| 0.0);
        Some(Self::of_passing(&passing, end, enclosing.unwrap_or(late)))
    }

    fn at_given_time(end: &Moment) -> Self {
        let numbers = end.state.len();
        let row = |result: usize| (0..numbers).map(|number| f64::from(u8::from(number == result))).collect();
        let errors = end.state.iter().map(|value| ROUNDING * value.abs()).chain([0.0]).collect();
        Self { slopes: (0..=numbers).map(row).collect(), end_errors: errors }
    }

    /// The outcome for a passage: the time changes by minus the deviation of the formula divided by its rate, and the state with the time.
    fn of_passing(passing: &Passing, end: &Moment, late: f64) -> Self {
        let time: Vec<f64> = passing.gradient.iter().map(|slope| -slope / passing.rate).collect();
        let late = late + ROUNDING * end.time.abs();
        let row = |(number, speed): (usize, &f64)| {
            let entry =
                |(column, slope): (usize, &f64)| f64::from(u8::from(column == number)) + speed * slope;
            time.iter().enumerate().map(entry).collect()
        };
        let slopes = passing.speeds.iter().enumerate().map(row).chain([time.clone()]).collect();
        let moving = passing.speeds.iter().zip(&end.state);
        let errors =
            moving.map(|(speed, value)| late * speed.abs() + ROUNDING * value.abs()).chain([late]).collect();
        Self { slopes, end_errors: errors }
    }
}
