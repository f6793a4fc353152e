//! The result to read.

use super::ending::{Ending, EventEnding};
use super::events::Happening;
use super::motion::SimulatedMotion;
use super::precision::Precision;
use super::report::{AnswerWriter, Sample, Summary};
use crate::output::number;
use crate::output::table::{Column, Table, paragraph, sheet, write_text};
use libration::systems::Model;
use libration::taylor::{Moment, MomentErrors};
use std::io::{self, Write};

/// The run in words, a table of samples, and the summary.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    table: Option<Table>,
    titles: Vec<String>,
    /// `true` if the samples are listed; a picture shows them better.
    listed: bool,
    happenings: Vec<Happening>,
    /// Number of samples and events that are not determined.
    left_out: usize,
}

impl AnswerWriter for Sheet {
    fn begin(&mut self, motion: &SimulatedMotion, out: &mut dyn Write) -> io::Result<()> {
        let model = motion.model;
        write_text(out, "", &format!("{} ({})", model.title(), motion.name()))?;
        writeln!(out, "{}", paragraph("  equations  ", &model.equation().to_string(), 120))?;
        if let Some(parameters) = parameters(motion) {
            writeln!(out, "{}", paragraph("  parameters ", &parameters, 120))?;
        }
        writeln!(out, "{}", paragraph("  begins at  ", &start(motion), 120))?;
        writeln!(out, "{}", paragraph("  tolerance  ", &motion.tolerances.to_string(), 120))?;
        if self.listed {
            writeln!(out)?;
        }
        self.titles = titles(model, &motion.column_names());
        let titles = || self.titles.iter().map(Column::numbers).collect();
        self.table = self.listed.then(|| Table::new(titles()));
        Ok(())
    }

    fn sample(&mut self, sample: &Sample, out: &mut dyn Write) -> io::Result<()> {
        let Sample { moment, columns, errors } = sample;
        if !is_determined(errors.as_ref()) {
            self.left_out += 1;
            return Ok(());
        }
        let numbers = [&moment.state, columns.as_deref().unwrap_or(&[])];
        let cells = cells_of(moment.time, numbers, errors.as_ref());
        self.table.as_mut().map_or(Ok(()), |table| table.row(out, cells))
    }

    fn event(&mut self, happening: &Happening, _: &mut dyn Write) -> io::Result<()> {
        if !is_determined(happening.errors.as_ref()) {
            self.left_out += 1;
        } else {
            self.happenings.push(happening.clone());
        }
        Ok(())
    }

    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()> {
        if let Some(table) = self.table.take() {
            table.finish(out)?;
        }
        if !self.happenings.is_empty() {
            self.write_events(out)?;
        }
        let drift = drift(&summary.drift);
        writeln!(out)?;
        let mut lines = vec![("energy drift", drift), ("steps", summary.steps.to_string())];
        lines.extend(self.precision(&summary.precision));
        if let Ending::Event(event) = &summary.ending {
            lines.insert(0, ("ends at", self.end_of(event)));
        }
        sheet(out, &lines)
    }
}

impl Sheet {
    pub(super) fn new(listed: bool) -> Self {
        Self { listed, ..Self::default() }
    }

    /// The state at which an event ended the motion, each number with its error.
    fn end_of(&self, EventEnding { name, end, error }: &EventEnding) -> String {
        let number = |title: &String, value: f64, error: f64| {
            let name = name_in(title);
            if error.is_nan() {
                return format!("{name} = {}", number::rounded(value, 15));
            }
            format!("{name} = {} ± {}", number::to_its_error(value, error, 15), number::at_most(error))
        };
        let state = self.titles[1..].iter().zip(&end.state).zip(&error.state);
        let state = state.map(|((title, value), error)| number(title, *value, *error));
        let all: Vec<String> =
            [number(&"t".to_owned(), end.time, error.time)].into_iter().chain(state).collect();
        format!("{} ({name})", all.join(", "))
    }

    /// The precision of the states.
    fn precision(&self, precision: &Precision) -> Vec<(&'static str, String)> {
        let (determined_until, Moment { time, state }) = match precision {
            Precision::Estimated { determined_until, start_effect } => (determined_until, start_effect),
            Precision::NotEstimated(reason) => return vec![("errors", not_estimated(reason))],
        };
        let lost = determined_until.map(|until| {
            let until = number::rounded(until, 6);
            let left_out = match self.left_out {
                0 => String::new(),
                1 => "; one row after it is left out here, not in --json and --csv".to_owned(),
                rows => format!("; {rows} rows after it are left out here, not in --json and --csv"),
            };
            ("determined", format!("not determined in double precision after t = {until} s{left_out}"))
        });
        let effects = self.titles[1..].iter().zip(state);
        let effects =
            effects.map(|(title, effect)| format!("{} {}", name_in(title), number::at_most(*effect)));
        let effects = effects.collect::<Vec<_>>().join(", ");
        let time = number::rounded(*time, 6);
        let start = format!(
            "half a unit in the last place of the start changes the state at t = {time} s by at most {effects}"
        );
        lost.into_iter().chain([("start", start)]).collect()
    }

    fn write_events(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out)?;
        let columns = self.titles.iter().map(Column::numbers);
        let mut table = Table::new(columns.chain([Column::words("event")]).collect());
        for event in &self.happenings {
            let columns = event.columns.as_deref().unwrap_or(&[]);
            let errors = event.errors.as_ref();
            let mut cells = cells_of(event.time, [&event.state, columns], errors);
            let time_error = errors.map_or(0.0, |errors| errors.time);
            cells[0] = number::to_its_error(event.time, time_error, 12);
            cells.push(event.kind.clone());
            table.row(out, cells)?;
        }
        table.finish(out)
    }
}

/// The titles of the time, the state components and the columns.
pub(super) fn titles(model: &Model, columns: &[String]) -> Vec<String> {
    let numbers = model.state_names().into_iter().zip(model.state_units());
    let numbers = numbers.map(|(name, unit)| labelled(&name, &unit));
    ["t / s".to_owned()].into_iter().chain(numbers).chain(columns.iter().cloned()).collect()
}

/// The drift of the energy, with its uncertainty if that exceeds rounding.
pub(super) fn drift(drift: &Result<[f64; 2], String>) -> String {
    match drift {
        Ok([drift, _]) if drift.is_nan() => "none: the energy is not defined throughout".to_owned(),
        Ok([drift, uncertainty]) => {
            let note = match *uncertainty > f64::EPSILON {
                true => {
                    format!("; the work of the forces is known to {} of it", number::rounded(*uncertainty, 2))
                }
                false => String::new(),
            };
            format!("{} of the largest kinetic energy{note}", number::rounded(*drift, 2))
        }
        Err(reason) => format!("none: {reason}"),
    }
}

/// A time, and the numbers of a state and the columns then, to their errors.
pub(super) fn cells_of(
    time: f64,
    [state, columns]: [&[f64]; 2],
    errors: Option<&MomentErrors>,
) -> Vec<String> {
    let to_error = |values: &[f64], errors: Option<&[f64]>| -> Vec<String> {
        let error = |number: usize| errors.map_or(0.0, |errors| errors[number]);
        let cell = |(number, value): (usize, &f64)| match error(number) {
            error if error.is_finite() => number::to_its_error(*value, error, 12),
            _ => "unknown".to_owned(),
        };
        values.iter().enumerate().map(cell).collect()
    };
    let state = to_error(state, errors.map(|errors| &*errors.state));
    let columns = to_error(columns, errors.map(|errors| &*errors.formulas));
    [vec![number::short(time, 12)], state, columns].concat()
}

/// No error is known, for a reason.
pub(super) fn not_estimated(reason: &str) -> String {
    format!("not estimated ({reason})")
}

fn is_determined(errors: Option<&MomentErrors>) -> bool {
    errors.is_none_or(|errors| errors.state.iter().all(|error| !error.is_nan()))
}

/// A title without its unit.
fn name_in(title: &str) -> &str {
    title.split(" / ").next().unwrap_or(title)
}

/// A name with its unit: `theta' / (rad/s)`.
fn labelled(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit if unit.contains('/') => format!("{name} / ({unit})"),
        unit => format!("{name} / {unit}"),
    }
}

/// The values of the parameters, with a note if they are the defaults of the pendulum that differ from those of other commands.
fn parameters(motion: &SimulatedMotion) -> Option<String> {
    let values = motion.model.values().iter().map(|(name, value)| format!("{name} = {value}"));
    let values = values.collect::<Vec<_>>().join(", ");
    let is_default = motion.model.value_of("omega0").is_some_and(|frequency| (frequency - 1.0).abs() <= 0.0);
    let swings = motion.model.key().is_some_and(|key| key.contains("pendulum"));
    let difference = match swings && is_default {
        true => {
            " (`libration period` assumes 1 m and 9.80665 m/s², so omega0 = 3.13: give --length 1m for the same)"
        }
        false => "",
    };
    (!values.is_empty()).then(|| values + difference)
}

/// The state at the start, with the assumed components.
fn start(motion: &SimulatedMotion) -> String {
    let state =
        motion.model.state_names().into_iter().zip(motion.model.state_units()).zip(&motion.initial.state);
    let given: Vec<String> =
        state.map(|((name, unit), value)| format!("{name} = {} {unit}", number::short(*value, 12))).collect();
    let given = given.iter().map(|text| text.trim_end()).collect::<Vec<_>>().join(", ");
    let assumed: Vec<&str> = motion.initial.assumed.iter().map(|(name, _)| name.as_str()).collect();
    match assumed.as_slice() {
        [] => given,
        names => format!("{given} ({} not given, so at rest)", names.join(", ")),
    }
}
