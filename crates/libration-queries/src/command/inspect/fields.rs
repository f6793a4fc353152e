//! Fields of a file, of its tables and columns, and of the traces that would be fitted.

use super::answer::{InspectResult, clock, range};
use crate::arguments::{of_columns, what_would_decide};
use crate::call;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json;
use libration_lab::measurement::{
    Channel, Finding, Format, MeasurementError, Observable, QuantityKind, Sheet, Trace,
};
use serde_json::Value;

/// A column of a table, with its number from 1.
pub(super) struct SheetColumn<'a> {
    sheet: &'a Sheet,
    number: usize,
    channel: &'a Channel,
}

pub(super) fn columns(sheet: &Sheet) -> Vec<SheetColumn<'_>> {
    let channels = sheet.channels.iter().zip(1..);
    channels.map(|(channel, number)| SheetColumn { sheet, number, channel }).collect()
}

pub(super) fn of_file() -> Fields<InspectResult> {
    type Of = Field<InspectResult>;
    Fields::from([
        Of::value("file", "", "name of the file", |it| it.file.as_str().into())
            .line_of("file", |it| it.file.clone()),
        Of::value("bytes", "1", "size of the file", |it| it.bytes.into()),
        Of::value("format", "", "kind of file, with the encoding of text", |it| format(it).into())
            .line_of("format", |it| format!("{}, {} bytes", format(it), it.bytes)),
        Of::nested("sheets[].", &of_sheet(), |it| of_sheet().records(it.recording.sheets())),
        Of::nested("traces[].", &of_trace(), |it| {
            of_trace().records(it.traces.iter().flat_map(|found| &found.traces))
        }),
        Of::value("gate_times", "1", "number of times of a photogate, or null", |it| {
            it.gates.as_ref().map(|gates| gates.times.len()).into()
        }),
        Of::present_value("table_fit", "", "command that would fit a table of periods", |it| {
            it.table_fit.as_ref().map(|fit| fit.command.into())
        }),
        Of::present_value("table_read_as[]", "", "roles of the columns in that fit", |it| {
            it.table_fit.as_ref().map(|fit| json::list(fit.read_as.sentences.clone()))
        }),
        Of::present_nested("table_columns[].", &of_columns(), |it| {
            it.table_fit.as_ref().map(|fit| of_columns().records(&fit.read_as.columns))
        }),
        Of::present_nested("column_values[].", &of_column_values(), |it| {
            it.with_values.then(|| of_column_values().records(&all_columns(it)))
        }),
        Of::present_nested("trace_values[].", &of_trace_values(), |it| {
            let traces = || it.traces.iter().flat_map(|found| &found.traces);
            it.with_values.then(|| of_trace_values().records(traces()))
        }),
        Of::nested("findings[].", &of_finding(), |it| of_finding().records(&it.findings())),
        Of::nested("undecided.", &of_error(), |it| {
            it.traces.as_ref().err().map(|error| of_error().record(error)).into()
        }),
        Of::present_nested("undecided_gate.", &of_error(), |it| {
            it.signals.as_ref().map(|error| of_error().record(error).into())
        }),
    ])
}

fn of_sheet() -> Fields<Sheet> {
    type Of = Field<Sheet>;
    Fields::from([
        Of::value("name", "", "name of the sheet, empty in text", |it| it.name.as_str().into()),
        Of::value("delimiter", "", "separator of the columns", |it| it.dialect.delimiter.to_string().into()),
        Of::value("decimal", "", "decimal mark", |it| it.dialect.mark.to_string().into()),
        Of::value("header_line", "1", "number of the line with the names of the columns, or null", |it| {
            it.header_line.into()
        }),
        Of::value("rows", "1", "rows of the table", |it| it.rows().into()),
        Of::nested("columns[].", &of_column(), |it| of_column().records(&columns(it))),
    ])
}

pub(super) fn of_column<'a>() -> Fields<SheetColumn<'a>> {
    type Of<'a> = Field<SheetColumn<'a>>;
    Fields::from([
        Of::value("sheet", "", "name of the sheet, empty in text", |it| it.sheet.name.as_str().into())
            .only_csv(),
        Of::value("number", "1", "number of the column, from 1", |it| it.number.into())
            .in_csv_as("column")
            .numeral("column", |it| it.number.to_string()),
        Of::value("name", "", "header of the column", |it| it.channel.heading.text.as_str().into())
            .words("name", |it| it.channel.heading.text.clone()),
        Of::value("quantity", "", "quantity that the header names, or –", |it| quantity(it.channel).into())
            .words("quantity", |it| quantity(it.channel)),
        Of::value("unit", "", "unit that the header names, or null", |it| it.unit().into())
            .words("unit", |it| it.unit().unwrap_or_default()),
        Of::value("run", "", "run that the header names, or null", |it| {
            it.channel.heading.run.as_deref().into()
        })
        .words("run", |it| it.channel.heading.run.clone().unwrap_or_default()),
        Of::value("numbers", "1", "cells that are numbers", |it| it.channel.count().into())
            .numeral("numbers", |it| it.channel.count().to_string()),
        Of::value("blanks", "1", "cells that are blank", |it| it.channel.blanks().into())
            .numeral("blank", |it| it.channel.blanks().to_string()),
        Of::value("words", "1", "cells that are neither", |it| it.channel.words().len().into())
            .numeral("words", |it| it.channel.words().len().to_string()),
        Of::nullable("smallest", "", "smallest number, in the unit of the file, or null", |it| {
            it.channel.range().map(|(smallest, _)| smallest)
        })
        .short("smallest", 7)
        .or("–"),
        Of::nullable("largest", "", "largest number, in the unit of the file, or null", |it| {
            it.channel.range().map(|(_, largest)| largest)
        })
        .short("largest", 7)
        .or("–"),
    ])
}

fn all_columns(answer: &InspectResult) -> Vec<SheetColumn<'_>> {
    answer.recording.sheets().iter().flat_map(columns).collect()
}

fn of_column_values<'a>() -> Fields<SheetColumn<'a>> {
    type Of<'a> = Field<SheetColumn<'a>>;
    Fields::from([
        Of::value("sheet", "", "name of the sheet, empty in text", |it| it.sheet.name.as_str().into()),
        Of::value("number", "1", "number of the column, from 1", |it| it.number.into()),
        Of::value("name", "", "header of the column", |it| it.channel.heading.text.as_str().into()),
        Of::value(
            "values[]",
            "",
            "its cells in the unit of the file, null where one is not a number",
            |it| json::list(it.channel.numbers().map(|number| number.map_or(Value::Null, json::number))),
        ),
    ])
}

fn of_trace_values() -> Fields<Trace> {
    type Of = Field<Trace>;
    Fields::from([
        Of::value("name", "", "name of the run", |it| it.name().into()),
        Of::value("unit", "", "unit of the values", |it| unit(it).into()),
        Of::value("times_s[]", "s", "times of the rows", |it| json::numbers(it.times())),
        Of::value("values[]", "", "values of the rows, in the unit above", |it| json::numbers(it.values())),
        Of::value("uncertainties[]", "", "their standard uncertainties, or null", |it| {
            it.uncertainties().map_or(Value::Null, json::numbers)
        }),
    ])
}

impl SheetColumn<'_> {
    fn unit(&self) -> Option<String> {
        let heading = &self.channel.heading;
        heading.unit.map(|unit| unit.to_string()).or_else(|| heading.unit_text.clone())
    }
}

fn of_trace() -> Fields<Trace> {
    type Of = Field<Trace>;
    Fields::from([
        Of::value("name", "", "name of the run", |it| it.name().into()),
        Of::value("seen", "", "measured quantity: angle or angular velocity", |it| observable(it).into()),
        Of::value("unit", "", "unit of the measured quantity, after conversion", |it| unit(it).into()),
        Of::value("rows", "1", "rows that would be fitted", |it| it.len().into()),
        Of::number("first_time_s", "s", "time of the first row", |it| it.times()[0]),
        Of::number("last_time_s", "s", "time of the last row", |it| it.times()[it.len() - 1]),
        Of::nullable("interval_s", "s", "time from row to row, or null where it varies", |it| {
            clock(it).map(|clock| clock.interval)
        }),
        Of::nullable("jitter_s", "s", "scatter of that time, or null", |it| {
            clock(it).map(|clock| clock.jitter)
        }),
        Of::number("smallest", "", "smallest value, in the unit above", |it| range(it).0),
        Of::number("largest", "", "largest value, in the unit above", |it| range(it).1),
        Of::value("has_uncertainties", "", "true if the rows have uncertainties", |it| {
            it.uncertainties().is_some().into()
        }),
    ])
}

fn of_finding() -> Fields<Finding> {
    type Of = Field<Finding>;
    Fields::from([
        Of::value("text", "", "settings inferred from the file", |it| it.text.as_str().into()),
        Of::value("option", "", "option that overrides it, or null", |it| {
            it.choice.map(|choice| format!("--{choice}")).into()
        }),
    ])
}

fn of_error() -> Fields<MeasurementError> {
    type Of = Field<MeasurementError>;
    Fields::from([
        Of::value("why", "", "reason why there is no trace, or no time of a gate", |it| {
            call::in_words(&what_would_decide(it)).into()
        }),
        Of::value("options[]", "", "options that would decide it", |it| match it {
            MeasurementError::Undecided { choices, .. } => {
                json::list(choices.iter().map(|it| format!("--{} {}", it.choice, it.value)))
            }
            _ => Value::Array(vec![]),
        }),
    ])
}

pub(super) fn answers() -> Vec<Answers> {
    let (json, csv) = (of_file().described(""), of_column().described_in_csv());
    vec![Answers { command: "inspect", option: "", json, csv }]
}

fn format(answer: &InspectResult) -> String {
    match answer.recording.format() {
        Format::Text(encoding) => format!("text, {encoding}"),
        Format::Xls => "Excel workbook (xls)".to_owned(),
        Format::Xlsx => "Excel workbook (xlsx)".to_owned(),
        _ => "ZIP archive of text files".to_owned(),
    }
}

pub(super) fn observable(trace: &Trace) -> &'static str {
    match trace.observable() {
        Observable::Angle => "angle",
        Observable::AngularVelocity => "angular velocity",
    }
}

fn unit(trace: &Trace) -> &'static str {
    match trace.observable() {
        Observable::Angle => "rad",
        Observable::AngularVelocity => "rad/s",
    }
}

fn quantity(channel: &Channel) -> String {
    let name = match channel.heading.quantity {
        QuantityKind::Time => "time",
        QuantityKind::Angle => "angle",
        QuantityKind::AngularVelocity => "angular velocity",
        QuantityKind::X => "x",
        QuantityKind::Y => "y",
        QuantityKind::Gate => "gate",
        QuantityKind::Run => "run",
        _ => return "–".to_owned(),
    };
    if channel.heading.is_uncertainty { format!("{name}, uncertainty") } else { name.to_owned() }
}
