//! Fields of the motions of a table.

use super::super::fields::{EVENT, of_end, of_event_alone, of_integration, of_sample_alone, of_time};
use super::super::report::Summary;
use super::SimulatedEach;
use super::list::Listed;
use crate::output::description::{Answers, DescriptionRow, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};

/// A motion with its table.
pub(super) struct NumberedMotion<'a> {
    pub(super) answer: &'a SimulatedEach<'a>,
    pub(super) listed: &'a Listed<'a>,
}

pub(super) fn of_answer<'a>() -> Fields<SimulatedEach<'a>> {
    type Of<'a> = Field<SimulatedEach<'a>>;
    Fields::from([
        Of::value("system", "", "key of the system, null where its equations were typed", |motion| {
            motion.model.key().into()
        }),
        Of::value(
            "equations",
            "",
            "equations of motion, with names in place of the values in the file",
            |motion| motion.model.equation().to_string().into(),
        ),
        Of::value("no_errors", "", "reason why no error of the states is estimated", |_| "--each".into()),
        Of::value("state[]", "", "names of the state variables", |motion| {
            json::list(motion.model.state_names())
        }),
        Of::present_value(
            "columns[]",
            "",
            "names of the formulas of --columns and of the derivatives of --sensitivity, else left out",
            |motion| {
                let columns = motion.column_names();
                (!columns.is_empty()).then(|| json::list(columns))
            },
        ),
    ])
}

/// The fields that identify a motion.
pub(super) fn of_number<'a>() -> Fields<NumberedMotion<'a>> {
    type Of<'a> = Field<NumberedMotion<'a>>;
    Fields::from([
        Of::value("motion", "1", "number of the motion, from 1 in the order of the file", |motion| {
            motion.listed.number.into()
        }),
        Of::present_value(
            "name",
            "",
            "its name, where the file has a column of names, else left out",
            |motion| motion.listed.name(motion.answer.table).map(Into::into),
        ),
    ])
}

/// The fields of the values that the file gives to it.
pub(super) fn of_values<'a>() -> Fields<NumberedMotion<'a>> {
    type Of<'a> = Field<NumberedMotion<'a>>;
    Fields::from([
        Of::value("parameters.NAME", "", "value of the parameter with this name, in its unit", |motion| {
            let add = |record: Record, (name, value): (&str, f64)| record.number(name, value);
            let values = motion.listed.motion.model.values().iter();
            let values = values.map(|(name, value)| (name.as_str(), value.to_f64().unwrap_or(f64::NAN)));
            values.fold(Record::new(), add).into()
        }),
        Of::value("initial[]", "", "state at t = 0, in the order of the names", |motion| {
            json::numbers(&motion.listed.motion.initial.state)
        }),
    ])
}

pub(super) fn of_summary() -> Fields<Summary> {
    of_integration().and(of_end())
}

pub(crate) fn answers() -> Answers {
    const NUMBER: DescriptionRow =
        ("NAME", "", "state variable of this name, formula of --columns, then derivative of --sensitivity");
    const MOTION: &str = "motions[].";
    let json = [
        of_answer().described(""),
        of_number().described(MOTION),
        of_values().described(MOTION),
        of_sample_alone().described("motions[].samples[]."),
        of_event_alone().described("motions[].events[]."),
        of_summary().described(MOTION),
    ];
    let csv =
        [of_number().described_in_csv(), of_time().described_in_csv(), descriptions("", &[NUMBER, EVENT])];
    Answers { command: "simulate", option: "--each", json: json.concat(), csv: csv.concat() }
}
