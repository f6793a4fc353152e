//! Fields of a simulated motion, of its samples and events, and at its end.

use super::ending::{Ending, EventEnding};
use super::events::Happening;
use super::motion::SimulatedMotion;
use super::precision::Precision;
use super::report::{Sample, Summary};
use super::resume::State;
use crate::output::description::{Answers, DescriptionRow, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use libration::taylor::{Moment, MomentErrors};
use serde_json::Value;

pub(super) fn of_motion<'a>() -> Fields<SimulatedMotion<'a>> {
    type Of<'a> = Field<SimulatedMotion<'a>>;
    Fields::from([
        Of::value("system", "", "key of the system, or its equations as they were read", |motion| {
            motion.name().into()
        }),
        Of::value("equations", "", "equations of motion with the values of all parameters", |motion| {
            motion.model.equation().to_string().into()
        }),
        Of::value("parameters.NAME", "", "value of the parameter with this name, in its unit", |motion| {
            let add = |record: Record, (name, value): (&str, f64)| record.number(name, value);
            let values = motion.model.values().iter();
            let values = values.map(|(name, value)| (name.as_str(), value.to_f64().unwrap_or(f64::NAN)));
            values.fold(Record::new(), add).into()
        }),
        Of::value("state[]", "", "names of the state variables", |motion| {
            json::list(motion.model.state_names())
        }),
        Of::present_value(
            "columns[]",
            "",
            "names of the formulas of --columns and of the derivatives of --sensitivity, else left out",
            |motion| {
                let names = motion.column_names();
                (!names.is_empty()).then(|| json::list(names))
            },
        ),
    ])
}

pub(super) fn of_sample() -> Fields<Sample> {
    type Of = Field<Sample>;
    of_sample_alone().and([
        Of::present_value(
            "error[]",
            "",
            "estimate of the error of each of these, null where the state is not determined; left out where none is estimated",
            |sample| sample.errors.as_ref().map(|errors| json::numbers(&errors.state)),
        ),
        Of::present_value("columns_error[]", "", OF_COLUMNS, |sample| of_columns(sample.errors.as_ref())),
    ])
}

const OF_COLUMNS: &str = "estimate of the error of each of columns[], null where the state is not determined or the formula has no value; left out \
                          where none is estimated";

fn of_columns(errors: Option<&MomentErrors>) -> Option<Value> {
    let errors = errors.filter(|errors| !errors.formulas.is_empty());
    errors.map(|errors| json::numbers(&errors.formulas))
}

/// The fields of a sample without errors.
pub(super) fn of_sample_alone() -> Fields<Sample> {
    type Of = Field<Sample>;
    Fields::from([
        Of::number("time_s", "s", "time of the sample", |sample| sample.moment.time),
        Of::value("state[]", "", "state then, in the order of the names", |sample| {
            json::numbers(&sample.moment.state)
        }),
        Of::present_value(
            "columns[]",
            "",
            "values of the formulas and derivatives then, in the order of their names",
            |sample| sample.columns.as_ref().map(|values| json::numbers(values)),
        ),
    ])
}

pub(super) fn of_event() -> Fields<Happening> {
    type Of = Field<Happening>;
    of_event_alone().and([
        Of::present_value(
            "time_error_s",
            "s",
            "estimate of the error of the time, null where the motion is not determined; left out where none is estimated",
            |event| event.errors.as_ref().map(|errors| json::number(errors.time)),
        ),
        Of::present_value(
            "error[]",
            "",
            "estimate of the error of each number of the state, as in samples",
            |event| event.errors.as_ref().map(|errors| json::numbers(&errors.state)),
        ),
        Of::present_value("columns_error[]", "", OF_COLUMNS, |event| of_columns(event.errors.as_ref())),
    ])
}

/// The fields of an event without errors.
pub(super) fn of_event_alone() -> Fields<Happening> {
    type Of = Field<Happening>;
    Fields::from([
        Of::number("time_s", "s", "time of the event", |event| event.time),
        Of::value("kind", "", "requested event, and how it touched zero if it did not cross it", |event| {
            event.kind.as_str().into()
        }),
        Of::value("state[]", "", "state then, in the order of the names", |event| {
            json::numbers(&event.state)
        }),
        Of::present_value(
            "columns[]",
            "",
            "values of the formulas and derivatives then, in the order of their names",
            |event| event.columns.as_ref().map(|values| json::numbers(values)),
        ),
    ])
}

/// The fields before the state in CSV.
pub(super) fn of_time() -> Fields<f64> {
    Fields::from([Field::number("time_s", "s", "time of the sample or event", |time| *time)])
}

/// The field after the state.
pub(super) const EVENT: DescriptionRow =
    ("event", "", "kind of the event, empty in samples; only with --events");

pub(super) fn of_summary() -> Fields<Summary> {
    let state = Field::present_nested("resume.", &State::fields(), |summary: &Summary| {
        summary.state.as_ref().map(|state| State::fields().record(state).into())
    });
    of_integration().and(of_precision()).and([state]).and(of_end())
}

/// The fields of the precision of the states.
fn of_precision() -> Fields<Summary> {
    type Of = Field<Summary>;
    Fields::from([
        Of::present(
            "determined_until_s",
            "s",
            "time after which the error of a state component exceeds a tenth of its largest magnitude so far; left out where \
             none does",
            |summary| match summary.precision {
                Precision::Estimated { determined_until, .. } => determined_until,
                Precision::NotEstimated(_) => None,
            },
        ),
        Of::present_nested("half_ulp_of_start.", &of_start_effect(), |summary| match &summary.precision {
            Precision::Estimated { start_effect, .. } => Some(of_start_effect().record(start_effect).into()),
            Precision::NotEstimated(_) => None,
        }),
        Of::present_value(
            "no_errors",
            "",
            "reason why no error of the states is estimated, left out where they are",
            |summary| match summary.precision {
                Precision::Estimated { .. } => None,
                Precision::NotEstimated(reason) => Some(reason.into()),
            },
        ),
    ])
}

/// The fields of the effect of the last digit of the start.
fn of_start_effect() -> Fields<Moment> {
    type Of = Field<Moment>;
    Fields::from([
        Of::number("time_s", "s", "time of the last state that is determined", |moment| moment.time),
        Of::value(
            "effect[]",
            "",
            "change of that state by half a unit in the last place of each number of the start, not included in the errors",
            |moment| json::numbers(&moment.state),
        ),
    ])
}

/// The errors in CSV.
pub(super) const TIME_ERROR: DescriptionRow = (
    "time_error_s",
    "s",
    "estimate of the error of the time of an event, empty in samples; only with --events",
);
const ERROR: DescriptionRow = (
    "NAME_error",
    "",
    "estimate of the error of the column of this name, empty where it is not determined; left out with --no-errors",
);

/// The fields of the accuracy of a motion.
pub(super) fn of_integration() -> Fields<Summary> {
    type Of = Field<Summary>;
    Fields::from([
        Of::known(
            "energy_drift",
            "1",
            "largest change of a conserved energy over the largest kinetic energy, or null",
            |summary| summary.drift.clone().map(|[drift, _]| drift),
        ),
        Of::nullable(
            "energy_drift_uncertainty",
            "1",
            "uncertainty of the drift, from the work of the forces, or null",
            |summary| summary.drift.as_ref().ok().map(|[_, uncertainty]| *uncertainty),
        ),
        Of::value("steps", "1", "steps of the integration", |summary| summary.steps.into()),
    ])
}

/// The fields of its end.
pub(super) fn of_end() -> Fields<Summary> {
    type Of = Field<Summary>;
    Fields::from([
        Of::present_value(
            "interrupted",
            "",
            "true where Ctrl-C ended the run early, else left out",
            |summary| matches!(summary.ending, Ending::Interrupted(_)).then(|| true.into()),
        ),
        Of::present_nested("until.", &of_ending(), |summary| match &summary.ending {
            Ending::Event(event) => Some(of_ending().record(event).into()),
            _ => None,
        }),
        Of::present_value(
            "stopped",
            "",
            "reason why the integration ended before the last time, else left out",
            |summary| match &summary.ending {
                Ending::NotReached(reason) | Ending::Stopped(reason) => Some(reason.as_str().into()),
                _ => None,
            },
        ),
    ])
}

/// The fields of the state at which the event of `--until` ended the motion.
fn of_ending() -> Fields<EventEnding> {
    type Of = Field<EventEnding>;
    Fields::from([
        Of::value("event", "", "event of --until that ended the motion; without it left out", |ending| {
            ending.name.as_str().into()
        }),
        Of::number("time_s", "s", "when", |ending| ending.end.time),
        Of::nullable("time_error_s", "s", "error of that time, null with --no-errors", |ending| {
            Some(ending.error.time).filter(|error| error.is_finite())
        }),
        Of::value("state[]", "", "state then, in the order of the names", |ending| {
            json::numbers(&ending.end.state)
        }),
        Of::value("state_error[]", "", "error of each of these", |ending| json::numbers(&ending.error.state)),
    ])
}

pub(super) fn answers() -> Answers {
    const NUMBER: DescriptionRow =
        ("NAME", "", "state variable of this name, formula of --columns, then derivative of --sensitivity");
    let json = [
        of_motion().described(""),
        of_sample().described("samples[]."),
        of_event().described("events[]."),
        of_summary().described(""),
    ];
    let csv = [of_time().described_in_csv(), descriptions("", &[NUMBER, TIME_ERROR, ERROR, EVENT])];
    Answers { command: "simulate", option: "", json: json.concat(), csv: csv.concat() }
}
