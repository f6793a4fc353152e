//! Section on which points are taken, and the number of points.

use super::values::plain_name;
use super::{count, positive};
use crate::output::{Form, number};
use crate::query_error::{Parameter, QueryError, option};
use libration::chaos::{Points, Section, SectionError, drive_period, folded};
use libration::expression::{Equation, Expression};
use libration::systems::{Model, condition};
use libration::taylor::{Direction, Effort};
use std::f64::consts::TAU;

/// More points than this are never requested.
const MOST_POINTS: usize = 10_000_000;

/// Options for the surface of a section and the number of its points.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct SectionOptions {
    /// Take a point once per period of this length, in seconds [default: the period of the drive]
    #[arg(long, value_name = "T", value_parser = positive, conflicts_with = "at")]
    period: Option<f64>,
    /// Take the points at this fraction of the period, from 0 to 1
    #[arg(long, default_value = "0", value_parser = phase, conflicts_with = "at")]
    phase: f64,
    /// Take a point whenever this formula of coordinates, velocities, parameters and t changes its sign, or two are equal, such as "theta = 0.5"
    #[arg(long, value_name = "FORMULA", value_parser = condition)]
    at: Option<Expression>,
    /// Direction in which the formula crosses zero
    #[arg(long, value_name = "SIDE", default_value = "rising", requires = "at")]
    direction: CrossingSide,
    /// Number of points to discard as transient [default: 100, but 0 for a section with --at]
    #[arg(long, value_name = "N", value_parser = whole)]
    skip: Option<usize>,
    /// Number of points to record
    #[arg(long, value_name = "N", value_parser = count::<MOST_POINTS>)]
    points: Option<usize>,
    /// The relative error allowed in each step
    #[arg(long, default_value = "1e-12", value_parser = positive)]
    tolerance: f64,
    /// Reduce angles to the range from −π to π, as pictures always do
    #[arg(long)]
    fold: bool,
    /// Do not estimate the errors of the states, which saves time
    #[arg(long)]
    no_errors: bool,
}

/// The direction in which a formula crosses zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum CrossingSide {
    /// From negative to positive
    Rising,
    /// From positive to negative
    Falling,
    /// Either way
    Any,
}

impl From<CrossingSide> for Direction {
    fn from(side: CrossingSide) -> Self {
        match side {
            CrossingSide::Rising => Self::Rising,
            CrossingSide::Falling => Self::Falling,
            CrossingSide::Any => Self::Any,
        }
    }
}

/// The numbers of the state components that are free on a section: all but one that is alone in the formula of the surface, without another and
/// the time.
pub(crate) fn free_on(section: &Section, model: &Model) -> Vec<usize> {
    let names = model.state_names();
    let mut free: Vec<usize> = (0..names.len()).collect();
    if let Section::Crossing { formula, .. } = section {
        let symbols =
            model.equation().with_rates(formula).symbols().into_iter().map(|symbol| symbol.to_string());
        let varying: Vec<String> = symbols.filter(|name| name == "t" || names.contains(name)).collect();
        free.retain(|&component| varying != [names[component].as_str()]);
    }
    free
}

impl SectionOptions {
    /// The section on which the points are taken: at each period given, or of the drive that the model is known to have, or at the zeros of a
    /// formula, which may contain only names of the system.
    pub(crate) fn section(&self, model: &Model) -> Result<Section, QueryError> {
        if let Some(formula) = &self.at {
            let zero = model.zero_of(&formula.to_string());
            let formula = zero.map_err(|error| QueryError::usage(option("at"), error))?;
            return Ok(Section::Crossing { formula, direction: self.direction.into() });
        }
        let drive_period = model.drive_frequency().map(|frequency| TAU / frequency.abs());
        let period = self.period.or(drive_period.filter(|period| period.is_finite()));
        Ok(Section::Stroboscope { period, phase: self.phase })
    }

    /// The numbers of points that are skipped and kept in a section: on a surface all, as most motions there keep their energy.
    pub(crate) fn points_of_section(&self, kept: usize) -> Points {
        let points = self.points_of_attractor(kept);
        let skipped = if self.at.is_some() { self.skip.unwrap_or(0) } else { points.skipped };
        Points { skipped, ..points }
    }

    /// The number of points after a transient.
    pub(crate) fn points_of_attractor(&self, kept: usize) -> Points {
        const TRANSIENT: usize = 100;
        Points { skipped: self.skip.unwrap_or(TRANSIENT), recorded: self.points.unwrap_or(kept) }
    }

    /// Returns `true` if errors are estimated: where points are listed, not beside a picture alone.
    pub(crate) fn with_errors(&self, is_drawn: bool, form: Form) -> bool {
        !self.no_errors && (!is_drawn || form != Form::Table)
    }

    pub(crate) fn effort(&self) -> Effort {
        Effort::to_tolerance(self.tolerance)
    }

    /// The state as it is printed, with angles folded if requested.
    pub(crate) fn shown(&self, state: &[f64], angles: &[bool]) -> Vec<f64> {
        if self.fold { folded_state(state, angles) } else { state.to_vec() }
    }

    /// A description of the section.
    pub(crate) fn description(&self, section: &Section, equation: &Equation) -> String {
        match section {
            Section::Crossing { formula, direction } => format!(
                "where {formula} {}",
                match direction {
                    Direction::Rising => "rises through zero",
                    Direction::Falling => "falls through zero",
                    Direction::Any => "changes its sign",
                }
            ),
            Section::Stroboscope { period, phase } => {
                let period = period.or_else(|| drive_period(equation));
                let period = period
                    .map_or_else(|| "period of the drive".to_owned(), |period| number::seconds(period, 10));
                format!("once every {period}, at phase {}", number::short(*phase, 6))
            }
        }
    }
}

/// A state with its angles in the turn from −π to π.
fn folded_state(state: &[f64], angles: &[bool]) -> Vec<f64> {
    let is_angle = angles.iter().copied().chain(std::iter::repeat(false));
    state.iter().zip(is_angle).map(|(value, angle)| if angle { folded(*value) } else { *value }).collect()
}

/// The index of the state component with this name.
pub(crate) fn place_in_state(model: &Model, argument: &Parameter, name: &str) -> Result<usize, QueryError> {
    let names = model.state_names();
    let index = names.iter().position(|other| *other == plain_name(name));
    index.ok_or_else(|| {
        QueryError::usage(
            argument,
            format!("the system has no state variable `{}`: it has {}", name.trim(), names.join(", ")),
        )
    })
}

/// The number of the coordinate with this name.
pub(crate) fn coordinate(model: &Model, argument: &Parameter, name: &str) -> Result<usize, QueryError> {
    let names: Vec<&str> = model.coordinates().iter().map(|coordinate| coordinate.name.as_str()).collect();
    names.iter().position(|other| *other == plain_name(name)).ok_or_else(|| {
        let available = names.join(", ");
        QueryError::usage(
            argument,
            format!("the system has no coordinate `{}`: it has {available}", name.trim()),
        )
    })
}

/// The indices of two state components, by their names.
pub(crate) fn places_in_state(
    model: &Model,
    argument: &Parameter,
    names: &str,
) -> Result<[usize; 2], QueryError> {
    match names.split(',').collect::<Vec<_>>()[..] {
        [across, up] => Ok([place_in_state(model, argument, across)?, place_in_state(model, argument, up)?]),
        _ => Err(QueryError::usage(argument, "give two names, such as theta,theta'")),
    }
}

/// The error with the argument to which it belongs.
pub(crate) fn section_failure(error: SectionError) -> QueryError {
    match error {
        SectionError::NoPeriod => QueryError::usage(option("period"), error),
        SectionError::WithoutValue(_) => QueryError::usage(option("at"), error),
        _ => QueryError::no_result("section", error),
    }
}

fn phase(text: &str) -> Result<f64, String> {
    let phase = text.trim().parse().ok().filter(|phase| (0.0..=1.0).contains(phase));
    phase.ok_or_else(|| "give a fraction of the period, from 0 to 1".to_owned())
}

fn whole(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|number| *number <= MOST_POINTS);
    number.ok_or_else(|| format!("give a whole number from 0 to {MOST_POINTS}"))
}
