//! Which formula overtakes which, and at which amplitude.

use crate::failure::Failure;
use crate::interrupt;
use crate::output::json::{self, Record};
use crate::output::progress::Progress;
use crate::output::table::{Column, Table};
use crate::output::{Form, csv, number};
use libration::period_formulas::{Crossover, ErrorTable, PeriodFormula};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, form: Form, formulas: &[PeriodFormula]) -> Result<(), Failure> {
    if formulas.len() < 2 {
        return Err(Failure::usage("--formulas", "one formula overtakes none: name at least two"));
    }
    interrupt::listen()?;
    let mut progress = Progress::new();
    let mut watch = |done, all| {
        progress.show(|| format!("{done} of {all} pairs of formulas"));
        interrupt::go_on()
    };
    let mut crossovers = ErrorTable::new(formulas).all_crossovers(&mut watch);
    drop(progress);
    crossovers.sort_by(|a, b| a.amplitude.radians().total_cmp(&b.amplitude.radians()));
    match form {
        Form::Json => {
            json::document_with_list(out, Record::new(), "crossovers", crossovers.iter().map(record))?;
        }
        Form::Csv => write_csv(out, &crossovers)?,
        Form::Table => write_table(out, &crossovers)?,
    }
    out.flush()?;
    interrupt::ended_early("the crossovers")
}

fn record(crossover: &Crossover) -> Record {
    Record::new()
        .number("amplitude_rad", crossover.amplitude.radians())
        .number("complement_rad", crossover.amplitude.complement())
        .with("better_below", crossover.better_below.as_str())
        .with("better_above", crossover.better_above.as_str())
        .number("error", crossover.error)
}

fn write_csv(out: &mut dyn Write, crossovers: &[Crossover]) -> io::Result<()> {
    csv::line(out, &["amplitude_rad", "complement_rad", "better_below", "better_above", "error"])?;
    for crossover in crossovers {
        let [radians, complement, error] =
            [crossover.amplitude.radians(), crossover.amplitude.complement(), crossover.error]
                .map(number::exact);
        let (below, above) = (crossover.better_below.clone(), crossover.better_above.clone());
        csv::line(out, &[radians, complement, below, above, error])?;
    }
    Ok(())
}

fn write_table(out: &mut dyn Write, crossovers: &[Crossover]) -> io::Result<()> {
    let mut table = Table::new(vec![
        Column::numbers("amplitude / °"),
        Column::words("better below"),
        Column::words("better above"),
        Column::numbers("|error| there"),
    ]);
    for crossover in crossovers {
        let degrees = number::rounded(crossover.amplitude.degrees(), 13);
        let (below, above) = (crossover.better_below.clone(), crossover.better_above.clone());
        table.row(out, vec![degrees, below, above, number::rounded(crossover.error, 3)])?;
    }
    table.finish(out)
}
