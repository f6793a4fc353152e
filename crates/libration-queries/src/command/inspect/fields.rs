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
        Of::value("file", "", "name of the file", |result| result.file.as_str().into())
            .line_of("file", |result| result.file.clone()),
        Of::value("bytes", "1", "size of the file", |result| result.bytes.into()),
        Of::value("format", "", "kind of file, with the encoding of text", |result| format(result).into())
            .line_of("format", |result| format!("{}, {} bytes", format(result), result.bytes)),
        Of::nested("sheets[].", &of_sheet(), |result| of_sheet().records(result.recording.sheets())),
        Of::nested("traces[].", &of_trace(), |result| {
            of_trace().records(result.traces.iter().flat_map(|traces| &traces.traces))
        }),
        Of::value("gate_times", "1", "number of times of a photogate, or null", |result| {
            result.gates.as_ref().map(|gates| gates.times.len()).into()
        }),
        Of::present_value("table_fit", "", "command that would fit a table of periods", |result| {
            result.table_fit.as_ref().map(|fit| fit.command.into())
        }),
        Of::present_value("table_read_as[]", "", "roles of the columns in that fit", |result| {
            result.table_fit.as_ref().map(|fit| json::list(fit.read_as.sentences.clone()))
        }),
        Of::present_nested("table_columns[].", &of_columns(), |result| {
            result.table_fit.as_ref().map(|fit| of_columns().records(&fit.read_as.columns))
        }),
        Of::present_nested("column_values[].", &of_column_values(), |result| {
            result.with_values.then(|| of_column_values().records(&all_columns(result)))
        }),
        Of::present_nested("trace_values[].", &of_trace_values(), |result| {
            let traces = || result.traces.iter().flat_map(|traces| &traces.traces);
            result.with_values.then(|| of_trace_values().records(traces()))
        }),
        Of::nested("findings[].", &of_finding(), |result| of_finding().records(&result.findings())),
        Of::nested("undecided.", &of_error(), |result| {
            result.traces.as_ref().err().map(|error| of_error().record(error)).into()
        }),
        Of::present_nested("undecided_gate.", &of_error(), |result| {
            result.signals.as_ref().map(|error| of_error().record(error).into())
        }),
    ])
}

fn of_sheet() -> Fields<Sheet> {
    type Of = Field<Sheet>;
    Fields::from([
        Of::value("name", "", "name of the sheet, empty in text", |sheet| sheet.name.as_str().into()),
        Of::value("delimiter", "", "separator of the columns", |sheet| {
            sheet.dialect.delimiter.to_string().into()
        }),
        Of::value("decimal", "", "decimal mark", |sheet| sheet.dialect.mark.to_string().into()),
        Of::value("header_line", "1", "number of the line with the names of the columns, or null", |sheet| {
            sheet.header_line.into()
        }),
        Of::value("rows", "1", "rows of the table", |sheet| sheet.rows().into()),
        Of::nested("columns[].", &of_column(), |sheet| of_column().records(&columns(sheet))),
    ])
}

pub(super) fn of_column<'a>() -> Fields<SheetColumn<'a>> {
    type Of<'a> = Field<SheetColumn<'a>>;
    Fields::from([
        Of::value("sheet", "", "name of the sheet, empty in text", |column| {
            column.sheet.name.as_str().into()
        })
        .only_csv(),
        Of::value("number", "1", "number of the column, from 1", |column| column.number.into())
            .in_csv_as("column")
            .numeral("column", |column| column.number.to_string()),
        Of::value("name", "", "header of the column", |column| column.channel.heading.text.as_str().into())
            .words("name", |column| column.channel.heading.text.clone()),
        Of::value("quantity", "", "quantity that the header names, or –", |column| {
            quantity(column.channel).into()
        })
        .words("quantity", |column| quantity(column.channel)),
        Of::value("unit", "", "unit that the header names, or null", |column| column.unit().into())
            .words("unit", |column| column.unit().unwrap_or_default()),
        Of::value("run", "", "run that the header names, or null", |column| {
            column.channel.heading.run.as_deref().into()
        })
        .words("run", |column| column.channel.heading.run.clone().unwrap_or_default()),
        Of::value("numbers", "1", "cells that are numbers", |column| column.channel.count().into())
            .numeral("numbers", |column| column.channel.count().to_string()),
        Of::value("blanks", "1", "cells that are blank", |column| column.channel.blanks().into())
            .numeral("blank", |column| column.channel.blanks().to_string()),
        Of::value("words", "1", "cells that are neither", |column| column.channel.words().len().into())
            .numeral("words", |column| column.channel.words().len().to_string()),
        Of::nullable("smallest", "", "smallest number, in the unit of the file, or null", |column| {
            column.channel.range().map(|(smallest, _)| smallest)
        })
        .short("smallest", 7)
        .or("–"),
        Of::nullable("largest", "", "largest number, in the unit of the file, or null", |column| {
            column.channel.range().map(|(_, largest)| largest)
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
        Of::value("sheet", "", "name of the sheet, empty in text", |column| {
            column.sheet.name.as_str().into()
        }),
        Of::value("number", "1", "number of the column, from 1", |column| column.number.into()),
        Of::value("name", "", "header of the column", |column| column.channel.heading.text.as_str().into()),
        Of::value(
            "values[]",
            "",
            "its cells in the unit of the file, null where one is not a number",
            |column| {
                json::list(column.channel.numbers().map(|number| number.map_or(Value::Null, json::number)))
            },
        ),
    ])
}

fn of_trace_values() -> Fields<Trace> {
    type Of = Field<Trace>;
    Fields::from([
        Of::value("name", "", "name of the run", |trace| trace.name().into()),
        Of::value("unit", "", "unit of the values", |trace| unit(trace).into()),
        Of::value("times_s[]", "s", "times of the rows", |trace| json::numbers(trace.times())),
        Of::value("values[]", "", "values of the rows, in the unit above", |trace| {
            json::numbers(trace.values())
        }),
        Of::value("uncertainties[]", "", "their standard uncertainties, or null", |trace| {
            trace.uncertainties().map_or(Value::Null, json::numbers)
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
        Of::value("name", "", "name of the run", |trace| trace.name().into()),
        Of::value("seen", "", "measured quantity: angle or angular velocity", |trace| {
            observable(trace).into()
        }),
        Of::value("unit", "", "unit of the measured quantity, after conversion", |trace| unit(trace).into()),
        Of::value("rows", "1", "rows that would be fitted", |trace| trace.len().into()),
        Of::number("first_time_s", "s", "time of the first row", |trace| trace.times()[0]),
        Of::number("last_time_s", "s", "time of the last row", |trace| trace.times()[trace.len() - 1]),
        Of::nullable("interval_s", "s", "time from row to row, or null where it varies", |trace| {
            clock(trace).map(|clock| clock.interval)
        }),
        Of::nullable("jitter_s", "s", "scatter of that time, or null", |trace| {
            clock(trace).map(|clock| clock.jitter)
        }),
        Of::number("smallest", "", "smallest value, in the unit above", |trace| range(trace).0),
        Of::number("largest", "", "largest value, in the unit above", |trace| range(trace).1),
        Of::value("has_uncertainties", "", "true if the rows have uncertainties", |trace| {
            trace.uncertainties().is_some().into()
        }),
    ])
}

fn of_finding() -> Fields<Finding> {
    type Of = Field<Finding>;
    Fields::from([
        Of::value("text", "", "settings inferred from the file", |finding| finding.text.as_str().into()),
        Of::value("option", "", "option that overrides it, or null", |finding| {
            finding.choice.map(|choice| format!("--{choice}")).into()
        }),
    ])
}

fn of_error() -> Fields<MeasurementError> {
    type Of = Field<MeasurementError>;
    Fields::from([
        Of::value("why", "", "reason why there is no trace, or no time of a gate", |error| {
            call::in_words(&what_would_decide(error)).into()
        }),
        Of::value("options[]", "", "options that would decide it", |error| match error {
            MeasurementError::Undecided { choices, .. } => {
                json::list(choices.iter().map(|choice| format!("--{} {}", choice.choice, choice.value)))
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
