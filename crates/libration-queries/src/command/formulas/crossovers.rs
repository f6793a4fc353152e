//! Crossovers of the formulas: the amplitudes at which one overtakes another.

use super::error_table::error_table;
use crate::interrupt;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::progress::ProgressLine;
use crate::output::table::Table;
use crate::output::{Form, csv, number};
use crate::query_error::{QueryError, option};
use libration::internals::InOrder;
use libration::period_formulas::{Crossover, PeriodFormula};
use libration::progress::Status;
use std::cell::RefCell;
use std::io::Write;

pub(super) fn write(out: &mut dyn Write, form: Form, formulas: &[PeriodFormula]) -> Result<(), QueryError> {
    if formulas.len() < 2 {
        return Err(QueryError::usage(
            option("formulas"),
            "crossovers are between formulas: name at least two",
        ));
    }
    let table = error_table(formulas)?;
    let line = RefCell::new(ProgressLine::new());
    let progress = |Status { done, of, .. }: Status| {
        line.borrow_mut().show(|| format!("{done} of {} pairs of formulas", of.unwrap_or(done)));
        interrupt::check()
    };
    let mut crossovers = table.all_crossovers(&progress);
    drop(line);
    crossovers.put_in_order(|a, b| a.amplitude.radians().total_cmp(&b.amplitude.radians()));
    let fields = of_crossover();
    match form {
        Form::Json => {
            let records = crossovers.iter().map(|crossover| fields.record(crossover));
            json::document_with_list(out, Record::new(), "crossovers", records)?;
        }
        Form::Csv => {
            csv::line(out, &fields.csv_names())?;
            crossovers.iter().try_for_each(|crossover| csv::line(out, &fields.csv_cells(crossover)))?;
        }
        Form::Table => {
            let mut table = Table::new(fields.columns());
            crossovers.iter().try_for_each(|crossover| table.row(out, fields.cells(crossover)))?;
            table.finish(out)?;
        }
    }
    out.flush()?;
    interrupt::ended_early("the crossovers")
}

fn of_crossover() -> Fields<Crossover> {
    type Of = Field<Crossover>;
    Fields::from([
        Of::number("amplitude_rad", "rad", "amplitude of the crossover", |crossover| {
            crossover.amplitude.radians()
        })
        .numeral("amplitude / °", |crossover| number::rounded(crossover.amplitude.degrees(), 13)),
        Of::number("complement_rad", "rad", "π minus that amplitude", |crossover| {
            crossover.amplitude.complement()
        }),
        Of::value("better_below", "", "formula with the smaller error directly below", |crossover| {
            crossover.better_below.as_str().into()
        })
        .words("better below", |crossover| crossover.better_below.clone()),
        Of::value("better_above", "", "formula with the smaller error directly above", |crossover| {
            crossover.better_above.as_str().into()
        })
        .words("better above", |crossover| crossover.better_above.clone()),
        Of::number("error", "1", "magnitude that the fractional errors of both have there", |crossover| {
            crossover.error
        })
        .rounded("|error| there", 3),
    ])
}

pub(super) fn answers() -> Answers {
    let fields = of_crossover();
    let json = fields.described("crossovers[].");
    Answers { command: "formulas", option: "--crossovers", json, csv: fields.described_in_csv() }
}
