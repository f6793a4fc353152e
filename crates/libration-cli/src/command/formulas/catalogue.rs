//! The formulas with their sources and errors.

use crate::output::json::{self, Record};
use crate::output::table::{Column, Table};
use crate::output::{Form, csv, number};
use libration::period_formulas::PeriodFormula;
use libration::quantity::Angle;
use std::f64::consts::FRAC_PI_2;
use std::io::{self, Write};

/// A formula with what is known about its error.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    formula: PeriodFormula,
    /// The largest fractional error up to 90°, with its sign.
    worst_error: f64,
    /// The amplitude (rad) up to which it keeps the tolerance, if one was given.
    holds_to: Option<f64>,
}

impl Entry {
    pub(super) fn new(formula: &PeriodFormula, holds_to: Option<f64>) -> Self {
        let [bottom, right_angle] =
            [0.0, FRAC_PI_2].map(|radians| Angle::from_radians(radians).expect("these are finite"));
        let worst = formula.worst_error(&bottom, &right_angle);
        Self { formula: formula.clone(), worst_error: worst.map_or(f64::NAN, |worst| worst.error), holds_to }
    }

    fn record(&self) -> Record {
        let formula = &self.formula;
        let record = Record::new()
            .with("key", formula.key())
            .with("name", formula.name())
            .with("authors", formula.authors())
            .with("year", formula.year())
            .with("source", formula.source())
            .with("latex", formula.latex())
            .with("domain", formula.domain())
            .with("complexity", formula.complexity().rank())
            .number("worst_error_to_90deg", self.worst_error.abs());
        match self.holds_to {
            Some(holds_to) => record.number("holds_to_rad", holds_to),
            None => record,
        }
    }

    fn year(&self) -> String {
        self.formula.year().map(|year| year.to_string()).unwrap_or_default()
    }
}

pub(super) fn write(out: &mut dyn Write, form: Form, entries: &[Entry]) -> io::Result<()> {
    match form {
        Form::Json => {
            json::document_with_list(out, Record::new(), "formulas", entries.iter().map(Entry::record))
        }
        Form::Csv => write_csv(out, entries),
        Form::Table => write_table(out, entries),
    }
}

fn write_csv(out: &mut dyn Write, entries: &[Entry]) -> io::Result<()> {
    let names = ["key", "authors", "year", "source", "latex", "worst_error_to_90deg", "holds_to_rad"];
    csv::line(out, &names)?;
    for entry in entries {
        let formula = &entry.formula;
        let worst_error = number::exact(entry.worst_error.abs());
        let holds_to = entry.holds_to.map(number::exact).unwrap_or_default();
        let words = [formula.key(), formula.authors(), &entry.year(), formula.source(), formula.latex()];
        csv::line(out, &[words.map(str::to_owned).to_vec(), vec![worst_error, holds_to]].concat())?;
    }
    Ok(())
}

fn write_table(out: &mut dyn Write, entries: &[Entry]) -> io::Result<()> {
    let with_tolerance = entries.iter().any(|entry| entry.holds_to.is_some());
    let mut columns = vec![Column::words("key"), Column::numbers("error to 90°")];
    if with_tolerance {
        columns.push(Column::numbers("holds to / °"));
    }
    columns.extend(["formula", "authors", "year"].map(Column::words));
    let mut table = Table::new(columns);
    for entry in entries {
        let mut cells = vec![entry.formula.key().to_owned(), number::rounded(entry.worst_error.abs(), 3)];
        cells.extend(entry.holds_to.map(|angle| number::rounded(angle.to_degrees(), 12)));
        cells.extend([entry.formula.name(), entry.formula.authors(), &entry.year()].map(str::to_owned));
        table.row(out, cells)?;
    }
    table.finish(out)
}
