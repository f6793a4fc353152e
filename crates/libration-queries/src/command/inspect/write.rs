//! A file of measurements as a sheet with a table of columns, as JSON, and as CSV of the columns.

use super::answer::{InspectResult, clock, range};
use super::fields::{self, SheetColumn, observable};
use crate::arguments::{finding_with_option, what_would_decide};
use crate::call;
use crate::output::number::short;
use crate::output::table::{paragraph, sheet, write_text};
use crate::output::{Form, json};
use crate::query_error::QueryError;
use libration_lab::measurement::{Choice, Gates, MeasurementError, Observable, Sheet, Trace};
use std::io::{self, Write};

pub(super) fn answer(out: &mut dyn Write, answer: &InspectResult, form: Form) -> Result<(), QueryError> {
    match form {
        Form::Json => json::document(out, fields::of_file().record(answer))?,
        Form::Csv => write_csv(out, answer)?,
        Form::Table => write_page(out, answer)?,
    }
    Ok(())
}

fn write_csv(out: &mut dyn Write, answer: &InspectResult) -> io::Result<()> {
    let columns: Vec<SheetColumn<'_>> = answer.recording.sheets().iter().flat_map(fields::columns).collect();
    fields::of_column().write_csv(out, &columns)
}

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 120;

fn write_page(out: &mut dyn Write, answer: &InspectResult) -> io::Result<()> {
    sheet(out, &fields::of_file().lines(answer))?;
    for table in answer.recording.sheets() {
        writeln!(out)?;
        write_sheet(out, table)?;
    }
    writeln!(out)?;
    write_what_would_be_fitted(out, answer)?;
    writeln!(out, "\ndetected in the file (the option overrides it)")?;
    for finding in answer.findings() {
        writeln!(out, "{}", paragraph("  - ", &finding_with_option(&finding), COLUMNS))?;
    }
    Ok(())
}

fn write_sheet(out: &mut dyn Write, sheet: &Sheet) -> io::Result<()> {
    let name = if sheet.name.is_empty() { "table".to_owned() } else { format!("sheet `{}`", sheet.name) };
    writeln!(out, "{name}: {} rows of {} columns", sheet.rows(), sheet.channels.len())?;
    fields::of_column().write_table(out, &fields::columns(sheet))
}

fn write_what_would_be_fitted(out: &mut dyn Write, answer: &InspectResult) -> io::Result<()> {
    match (&answer.traces, &answer.gates) {
        (Ok(traces), _) => {
            writeln!(out, "`libration fit trace` would fit")?;
            traces
                .traces
                .iter()
                .try_for_each(|trace| writeln!(out, "{}", paragraph("  - ", &trace_line(trace), COLUMNS)))
        }
        (Err(_), Some(gates)) => write_text(out, "`libration fit gates` would fit ", &gates_line(gates)),
        (Err(_), None) if answer.table_fit.is_some() => write_table_fit(out, answer),
        (Err(error), None) => {
            writeln!(
                out,
                "{}",
                paragraph("no trace yet: ", &call::in_words(&what_would_decide(error)), COLUMNS)
            )?;
            if let Some(error) = &answer.signals {
                let question = call::in_words(&what_would_decide(error));
                writeln!(out, "{}", paragraph("no gate yet: ", &question, COLUMNS))?;
            }
            if has_no_time(error) {
                let tables = "tables of periods are for `libration fit periods` and `libration fit lengths`";
                writeln!(out, "{tables}")?;
            }
            Ok(())
        }
    }
}

fn write_table_fit(out: &mut dyn Write, answer: &InspectResult) -> io::Result<()> {
    let Some(fit) = &answer.table_fit else { return Ok(()) };
    writeln!(out, "`libration {}` would fit the table", fit.command)?;
    fit.read_as.sentences.iter().try_for_each(|note| writeln!(out, "{}", paragraph("  - ", note, COLUMNS)))
}

fn has_no_time(error: &MeasurementError) -> bool {
    match error {
        MeasurementError::Undecided { choices, .. } => {
            choices.iter().all(|choice| choice.choice == Choice::Time)
        }
        _ => false,
    }
}

fn trace_line(trace: &Trace) -> String {
    let name = if trace.name().is_empty() { String::new() } else { format!("{}: ", trace.name()) };
    let (low, high) = range(trace);
    let (first, last) = (trace.times()[0], trace.times()[trace.len() - 1]);
    let clock = clock(trace).map_or_else(String::new, |clock| {
        let interval = short(clock.interval, 7);
        // Rounding of written times is not jitter.
        match clock.jitter > 1e-6 * clock.interval {
            true => format!(", every {interval} s (jitter {} s)", short(clock.jitter, 2)),
            false => format!(", every {interval} s"),
        }
    });
    let weights = if trace.uncertainties().is_some() { ", with uncertainties" } else { "" };
    let [low, high] = [low, high].map(|value| in_degrees(value, trace));
    let [first, last] = [first, last].map(|time| short(time, 9));
    format!(
        "{name}{} in {} rows from {first} s to {last} s{clock}, between {low} and {high}{weights}",
        observable(trace),
        trace.len()
    )
}

fn in_degrees(value: f64, trace: &Trace) -> String {
    match trace.observable() {
        Observable::Angle => format!("{}°", short(value.to_degrees(), 4)),
        Observable::AngularVelocity => format!("{} rad/s", short(value, 4)),
    }
}

fn gates_line(gates: &Gates) -> String {
    let states = if gates.blocked.is_some() { "with the state of the gate" } else { "without states" };
    let ends = [gates.times[0], gates.times[gates.times.len() - 1]].map(|time| short(time, 9));
    format!("{} times of a photogate from {} s to {} s, {states}", gates.times.len(), ends[0], ends[1])
}
