//! The errors of section points in tables, JSON and CSV.

use crate::output::{csv, description::DescriptionRow, json, number};
use libration::chaos::PoincareSection;
use libration::systems::Model;
use libration::taylor::MomentErrors;
use serde_json::Value;

/// Number of digits of values in tables, and of states of a nearby motion, which a picture shows as well.
const DIGITS: usize = 10;
const NEARBY_DIGITS: usize = 3;

/// The errors of a point: `None` if none were estimated, and within if the motion is not determined there.
#[derive(Clone, Copy)]
pub(crate) struct PointErrors<'a>(Option<Option<&'a MomentErrors>>);

impl<'a> PointErrors<'a> {
    pub(crate) fn of(section: &'a PoincareSection, index: usize) -> Self {
        Self(section.errors.as_ref().map(|errors| errors.of_points.get(index)))
    }

    pub(crate) fn of_time(self) -> Option<Value> {
        self.0.map(|errors| json::number(errors.map_or(f64::NAN, |errors| errors.time)))
    }

    pub(crate) fn of_state(self, state: &[f64]) -> Option<Value> {
        self.0.map(|errors| match errors {
            Some(errors) => json::numbers(&errors.state),
            None => json::numbers(&vec![f64::NAN; state.len()]),
        })
    }

    /// The state, then the errors of time and state.
    pub(crate) fn csv_cells(self, state: &[f64]) -> impl Iterator<Item = String> {
        let errors = self.0.map(|errors| match errors {
            Some(errors) => [&[errors.time], &errors.state[..]].concat(),
            None => vec![f64::NAN; 1 + state.len()],
        });
        let numbers = [state.to_vec(), errors.unwrap_or_default()].concat();
        numbers.into_iter().map(csv::number)
    }

    /// Time and state, with the digits up to their errors; few of a state that is not determined.
    pub(crate) fn cells(self, time: f64, state: &[f64]) -> Vec<String> {
        let errors = self.0.flatten();
        let digits = if self.0.is_some() && errors.is_none() { NEARBY_DIGITS } else { DIGITS };
        let cell = |value: f64, error: Option<f64>, digits| {
            number::to_its_error(value, error.unwrap_or(0.0), digits)
        };
        let state = state.iter().enumerate();
        let state = state.map(|(i, value)| cell(*value, errors.map(|errors| errors.state[i]), digits));
        [cell(time, errors.map(|errors| errors.time), DIGITS)].into_iter().chain(state).collect()
    }
}

pub(crate) const MEANING: &str = "estimate of the error, null where the motion is not determined; left out with --no-errors, and for a state of more than 64 numbers";

pub(crate) const DETERMINED: &str = "time of the last state of each motion that is determined in double precision, null where all are, or where no errors are estimated; \
     later points are those of a nearby motion";

pub(crate) fn determined_until<'a>(sections: impl IntoIterator<Item = &'a PoincareSection>) -> Value {
    let until = sections.into_iter().map(|section| section.errors.as_ref()?.determined_until);
    json::list(until.map(|until| until.map_or(Value::Null, json::number)))
}

/// The columns of CSV.
pub(crate) const IN_CSV: [DescriptionRow; 2] = [
    (
        "time_error_s",
        "s",
        "estimate of the error of the time, empty where the motion is not determined; left out with --no-errors, and for a state of more than 64 numbers",
    ),
    ("NAME_error", "", "that of the column of this name"),
];

pub(crate) fn csv_names(model: &Model) -> Vec<String> {
    let of_state = model.state_names();
    [IN_CSV[0].0.to_owned()].into_iter().chain(of_state.iter().map(|name| csv::error_of(name))).collect()
}
