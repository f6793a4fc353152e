//! A file of measurements as a sheet with a table of columns, as JSON, and as CSV of the columns.

use super::answer::{Answer, clock, range};
use crate::arguments::{told, what_would_decide};
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::number::{exact, short};
use crate::output::table::{Column, Table, paragraph, sheet, write_text};
use crate::output::{Form, csv};
use libration_lab::measurement::{
    Channel, Choice, Finding, Format, Gates, MeasurementError, Quantity, Seen, Sheet, Trace,
};
use serde_json::Value;
use std::io::{self, Write};

pub(super) fn answer(out: &mut dyn Write, answer: &Answer, form: Form) -> Result<(), Failure> {
    match form {
        Form::Json => json::document(out, record(answer))?,
        Form::Csv => write_csv(out, answer)?,
        Form::Table => write_page(out, answer)?,
    }
    Ok(())
}

fn record(answer: &Answer) -> Record {
    let sheets: Vec<Value> = answer.recording.sheets().iter().map(|it| sheet_record(it).into()).collect();
    let traces = answer.traces.as_ref().map_or(Vec::new(), |found| found.traces.iter().collect());
    let traces: Vec<Value> = traces.into_iter().map(|it| trace_record(it).into()).collect();
    let findings: Vec<Value> = answer.findings().iter().map(|it| finding_record(it).into()).collect();
    Record::new()
        .with("file", answer.file.as_str())
        .with("bytes", answer.bytes)
        .with("format", format(answer))
        .with("sheets", sheets)
        .with("traces", traces)
        .with("gate_times", answer.gates.as_ref().map(|gates| gates.times.len()))
        .with("findings", findings)
        .with("undecided", answer.traces.as_ref().err().map(|error| Value::from(undecided_record(error))))
}

fn sheet_record(sheet: &Sheet) -> Record {
    let columns: Vec<Value> =
        sheet.channels.iter().zip(1..).map(|(it, number)| column_record(number, it).into()).collect();
    Record::new()
        .with("name", sheet.name.as_str())
        .with("delimiter", sheet.dialect.delimiter.to_string())
        .with("decimal", sheet.dialect.mark.to_string())
        .with("header_line", sheet.header_line)
        .with("rows", sheet.rows())
        .with("columns", columns)
}

fn column_record(number: usize, channel: &Channel) -> Record {
    let heading = &channel.heading;
    let (smallest, largest) = channel.range().unzip();
    Record::new()
        .with("number", number)
        .with("name", heading.text.as_str())
        .with("quantity", quantity(channel))
        .with("unit", heading.unit.map(|unit| unit.to_string()).or_else(|| heading.unit_text.clone()))
        .with("run", heading.run.as_deref())
        .with("numbers", channel.count())
        .with("blanks", channel.blanks())
        .with("words", channel.words().len())
        .with("smallest", smallest)
        .with("largest", largest)
}

fn trace_record(trace: &Trace) -> Record {
    let (low, high) = range(trace);
    let clock = clock(trace);
    Record::new()
        .with("name", trace.name())
        .with("seen", seen(trace))
        .with("unit", unit(trace))
        .with("rows", trace.len())
        .number("first_time_s", trace.times()[0])
        .number("last_time_s", trace.times()[trace.len() - 1])
        .with("interval_s", clock.as_ref().map(|clock| clock.interval))
        .with("jitter_s", clock.as_ref().map(|clock| clock.jitter))
        .number("smallest", low)
        .number("largest", high)
        .with("has_uncertainties", trace.uncertainties().is_some())
}

fn finding_record(finding: &Finding) -> Record {
    let option = finding.choice.map(|choice| format!("--{choice}"));
    Record::new().with("text", finding.text.as_str()).with("option", option)
}

fn undecided_record(error: &MeasurementError) -> Record {
    let options = match error {
        MeasurementError::Undecided { choices, .. } => {
            choices.iter().map(|it| format!("--{} {}", it.choice, it.value)).collect()
        }
        _ => Vec::new(),
    };
    Record::new().with("why", what_would_decide(error)).with("options", options)
}

fn write_csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let names = [
        "sheet", "column", "name", "quantity", "unit", "run", "numbers", "blanks", "words", "smallest",
        "largest",
    ];
    csv::line(out, &names)?;
    for sheet in answer.recording.sheets() {
        for (channel, number) in sheet.channels.iter().zip(1..) {
            let range = channel
                .range()
                .map_or([String::new(), String::new()], |(low, high)| [exact(low), exact(high)]);
            let text = [vec![sheet.name.clone()], cells(number, channel), range.to_vec()].concat();
            csv::line(out, &text)?;
        }
    }
    Ok(())
}

/// Number, name, quantity, unit, run, numbers, blanks, words.
fn cells(number: usize, channel: &Channel) -> Vec<String> {
    let heading = &channel.heading;
    let unit = heading.unit.map(|unit| unit.to_string()).or_else(|| heading.unit_text.clone());
    let counts = [channel.count(), channel.blanks(), channel.words().len()].map(|count| count.to_string());
    let words = [
        heading.text.clone(),
        quantity(channel),
        unit.unwrap_or_default(),
        heading.run.clone().unwrap_or_default(),
    ];
    [vec![number.to_string()], words.to_vec(), counts.to_vec()].concat()
}

/// Where lines are broken.
const COLUMNS: usize = 120;

fn write_page(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    sheet(
        out,
        &[("file", answer.file.clone()), ("format", format!("{}, {} bytes", format(answer), answer.bytes))],
    )?;
    for table in answer.recording.sheets() {
        writeln!(out)?;
        write_sheet(out, table)?;
    }
    writeln!(out)?;
    write_what_would_be_fitted(out, answer)?;
    writeln!(out, "\ndetected in the file (the option overrides it)")?;
    for finding in answer.findings() {
        writeln!(out, "{}", paragraph("  - ", &told(&finding), COLUMNS))?;
    }
    Ok(())
}

fn write_sheet(out: &mut dyn Write, sheet: &Sheet) -> io::Result<()> {
    let name = if sheet.name.is_empty() { "table".to_owned() } else { format!("sheet `{}`", sheet.name) };
    writeln!(out, "{name}: {} rows of {} columns", sheet.rows(), sheet.channels.len())?;
    let right = ["numbers", "blank", "words", "smallest", "largest"].map(Column::numbers);
    let left = ["name", "quantity", "unit", "run"].map(Column::words);
    let mut table = Table::new([vec![Column::numbers("column")], left.to_vec(), right.to_vec()].concat());
    for (channel, number) in sheet.channels.iter().zip(1..) {
        let range = channel
            .range()
            .map_or(["–".to_owned(), "–".to_owned()], |(low, high)| [short(low, 7), short(high, 7)]);
        table.row(out, [cells(number, channel), range.to_vec()].concat())?;
    }
    table.finish(out)
}

fn write_what_would_be_fitted(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    match (&answer.traces, &answer.gates) {
        (Ok(found), _) => {
            writeln!(out, "`libration fit trace` would fit")?;
            found
                .traces
                .iter()
                .try_for_each(|trace| writeln!(out, "{}", paragraph("  - ", &trace_line(trace), COLUMNS)))
        }
        (Err(_), Some(gates)) => write_text(out, "`libration fit gates` would fit ", &gates_line(gates)),
        (Err(error), None) => {
            writeln!(out, "{}", paragraph("no trace yet: ", &what_would_decide(error), COLUMNS))?;
            if has_no_time(error) {
                let tables = "tables of periods are for `libration fit periods` and `libration fit lengths`";
                writeln!(out, "{tables}")?;
            }
            Ok(())
        }
    }
}

fn has_no_time(error: &MeasurementError) -> bool {
    match error {
        MeasurementError::Undecided { choices, .. } => choices.iter().all(|it| it.choice == Choice::Time),
        _ => false,
    }
}

fn trace_line(trace: &Trace) -> String {
    let name = if trace.name().is_empty() { String::new() } else { format!("{}: ", trace.name()) };
    let (low, high) = range(trace);
    let (first, last) = (trace.times()[0], trace.times()[trace.len() - 1]);
    let clock = clock(trace).map_or_else(String::new, |clock| {
        let interval = short(clock.interval, 7);
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
        seen(trace),
        trace.len()
    )
}

fn in_degrees(value: f64, trace: &Trace) -> String {
    match trace.seen() {
        Seen::Angle => format!("{}°", short(value.to_degrees(), 4)),
        Seen::AngularVelocity => format!("{} rad/s", short(value, 4)),
    }
}

fn gates_line(gates: &Gates) -> String {
    let states = if gates.blocked.is_some() { "with the state of the gate" } else { "without states" };
    let ends = [gates.times[0], gates.times[gates.times.len() - 1]].map(|time| short(time, 9));
    format!("{} times of a photogate from {} s to {} s, {states}", gates.times.len(), ends[0], ends[1])
}

fn format(answer: &Answer) -> String {
    match answer.recording.format() {
        Format::Text(encoding) => format!("text, {encoding}"),
        Format::Xls => "Excel workbook (xls)".to_owned(),
        Format::Xlsx => "Excel workbook (xlsx)".to_owned(),
        _ => "ZIP archive of text files".to_owned(),
    }
}

fn seen(trace: &Trace) -> &'static str {
    match trace.seen() {
        Seen::Angle => "angle",
        Seen::AngularVelocity => "angular velocity",
    }
}

fn unit(trace: &Trace) -> &'static str {
    match trace.seen() {
        Seen::Angle => "rad",
        Seen::AngularVelocity => "rad/s",
    }
}

fn quantity(channel: &Channel) -> String {
    let name = match channel.heading.quantity {
        Quantity::Time => "time",
        Quantity::Angle => "angle",
        Quantity::AngularVelocity => "angular velocity",
        Quantity::X => "x",
        Quantity::Y => "y",
        Quantity::Gate => "gate",
        Quantity::Run => "run",
        _ => return "–".to_owned(),
    };
    if channel.heading.is_uncertainty { format!("{name}, uncertainty") } else { name.to_owned() }
}
