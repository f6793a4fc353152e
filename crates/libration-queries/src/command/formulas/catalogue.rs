//! The formulas with their sources and errors.

use super::entry::Entry;
use super::formula_sheet;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::table::{Table, write_text};
use crate::output::{Form, csv};
use libration::period_formulas::ABBREVIATIONS;
use std::io::{self, Write};

/// Width of the widest formula in the table, next to the longest key; longer ones are printed in their sheets only.
const WIDEST: usize = 59;

fn of_entry() -> Fields<Entry> {
    type Of = Field<Entry>;
    let fields = Fields::from([
        Of::value("key", "", "short name of the formula", |entry| entry.formula.key().into())
            .words("key", |entry| entry.formula.key().to_owned()),
        Of::value("name", "", "name of the formula", |entry| entry.formula.name().into())
            .only_json()
            .words("formula", |entry| entry.formula.name().to_owned()),
        Of::value("family", "", "series or iteration that it is a member of, or its key", |entry| {
            entry.formula.family().into()
        })
        .only_json(),
        Of::value("authors", "", "authors of the publication", |entry| entry.formula.authors().into())
            .words("authors", |entry| entry.formula.authors().to_owned()),
        Of::value("year", "", "year of the publication, null where it is not known", |entry| {
            entry.formula.year().into()
        })
        .words("year", |entry| entry.formula.year().map_or_else(String::new, |year| year.to_string())),
        Of::value("source", "", "source of the formula", |entry| entry.formula.source().into()),
        Of::value(
            "formula",
            "",
            "T/T0, with c = cos(θ0/2), k = sin(θ0/2), s = √c, L = ln(4/c)",
            |entry| entry.formula.text().into(),
        )
        .words("T/T0", |entry| {
            let text = entry.formula.text();
            if text.chars().count() > WIDEST { entry.formula.name().to_owned() } else { text.to_owned() }
        }),
        Of::value("latex", "", "the formula in LaTeX", |entry| entry.formula.latex().into()),
        Of::value("derivation", "", "the argument that leads to the formula", |entry| {
            entry.formula.derivation().into()
        })
        .only_json(),
        Of::value("domain", "", "domain in which it is good, and its limit at the end", |entry| {
            entry.formula.domain().into()
        })
        .only_json(),
        Of::value("complexity", "1", "effort: an operation counts 1, a root 2, a function 3", |entry| {
            entry.formula.complexity().rank().into()
        })
        .only_json(),
        Of::number(
            "worst_error_to_90deg",
            "1",
            "largest magnitude of its fractional error up to 90°",
            |entry| entry.formula.worst_error_to_90deg().abs(),
        )
        .rounded("error to 90°", 3),
        Of::present(
            "holds_to_rad",
            "rad",
            "amplitude up to which it is within the given tolerance",
            |entry| entry.holds_to,
        )
        .degrees("holds to / °", 12),
    ]);
    fields.and(formula_sheet::of_curve())
}

pub(super) fn write(out: &mut dyn Write, form: Form, entries: &[Entry]) -> io::Result<()> {
    let fields = of_entry();
    match form {
        Form::Json => {
            let records = entries.iter().map(|entry| fields.record(entry));
            json::document_with_list(out, Record::new(), "formulas", records)
        }
        Form::Csv => {
            csv::line(out, &fields.csv_names())?;
            entries.iter().try_for_each(|entry| csv::line(out, &fields.csv_cells(entry)))
        }
        Form::Table if entries.iter().any(|entry| entry.is_sheet) => formula_sheet::write(out, entries),
        Form::Table => write_table(out, entries),
    }
}

fn write_table(out: &mut dyn Write, entries: &[Entry]) -> io::Result<()> {
    let with_tolerance = entries.iter().any(|entry| entry.holds_to.is_some());
    let titles = ["key", "error to 90°", "holds to / °", "T/T0", "authors", "year"];
    let titles = titles.into_iter().filter(|title| with_tolerance || *title != "holds to / °");
    let fields = of_entry().for_table(&titles.collect::<Vec<_>>());
    let mut table = Table::new(fields.columns());
    entries.iter().try_for_each(|entry| table.row(out, fields.cells(entry)))?;
    table.finish(out)?;
    writeln!(out)?;
    write_text(out, "", ABBREVIATIONS)
}

pub(super) fn answers() -> Answers {
    let fields = of_entry();
    let json = fields.described("formulas[].");
    Answers { command: "formulas", option: "", json, csv: fields.described_in_csv() }
}
