//! The file of a length table: its columns and their units.

use crate::arguments::{AmplitudeUnit, ColumnsInSi, DialectOptions, LengthUnit, Wanted, optional_column};
use crate::failure::Failure;
use libration::fit::{LengthColumns, LengthTable};
use libration::measurement::Column;
use libration::quantity::{Angle, Quantity};
use std::path::PathBuf;

/// Which file, and how to read it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Input {
    /// A table of lengths and periods, perhaps with their uncertainties; - for the standard input
    file: PathBuf,
    /// Columns of length, period, the uncertainties of both, and amplitude, by number or name; - for none [default: 1,2 or 1,2,3,4]
    #[arg(long, value_name = "COLUMN,…", value_delimiter = ',')]
    columns: Vec<String>,
    /// Unit of the lengths and of their uncertainties [default: that of the header, else m]
    #[arg(long, value_enum)]
    length_unit: Option<LengthUnit>,
    /// The amplitude of all swings, such as 10deg [default: small]
    #[arg(long, value_name = "ANGLE", value_parser = crate::arguments::angle)]
    amplitude: Option<Angle>,
    /// Unit of a column of amplitudes [default: that of the header, else rad]
    #[arg(long, value_enum)]
    amplitude_unit: Option<AmplitudeUnit>,
    /// The times are half periods: from one side to the other
    #[arg(long)]
    half_periods: bool,
    #[command(flatten)]
    dialect: DialectOptions,
}

/// What was measured, in m and s, and the table to fit.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) lengths: Vec<f64>,
    pub(crate) periods: Vec<f64>,
    pub(crate) length_uncertainties: Option<Vec<f64>>,
    pub(crate) period_uncertainties: Option<Vec<f64>>,
    pub(crate) table: LengthTable,
    pub(super) dropped: usize,
    /// The units that the header says.
    pub(super) told: Vec<String>,
    pub(super) half_periods: bool,
}

impl Input {
    pub(super) fn name(&self) -> String {
        self.file.display().to_string()
    }

    pub(super) fn read(&self) -> Result<Measured, Failure> {
        let table = self.dialect.read(&self.file)?;
        let columns = self.columns(table.width())?;
        let read =
            ColumnsInSi::of(&table, &columns, &self.wanted()).map_err(|error| self.no_answer(error))?;
        let [lengths, periods, length_uncertainties, of_periods, amplitudes] = read.columns;
        let full = |column: Vec<f64>| match self.half_periods {
            true => column.into_iter().map(|time| 2.0 * time).collect(),
            false => column,
        };
        let lengths = lengths.unwrap_or_default();
        let periods: Vec<f64> = full(periods.unwrap_or_default());
        let period_uncertainties = of_periods.map(full);
        let columns = LengthColumns {
            lengths: &lengths,
            periods: &periods,
            length_uncertainties: length_uncertainties.as_deref(),
            period_uncertainties: period_uncertainties.as_deref(),
            amplitudes: &self.amplitudes(amplitudes)?,
        };
        let table = LengthTable::new(&columns).map_err(|error| self.no_answer(error))?;
        Ok(Measured {
            lengths,
            periods,
            length_uncertainties,
            period_uncertainties,
            table,
            dropped: read.dropped,
            told: read.told,
            half_periods: self.half_periods,
        })
    }

    fn wanted(&self) -> [Wanted; 5] {
        let (lengths, periods) = (Wanted::lengths(self.length_unit), Wanted::times());
        let of_both = [lengths.uncertainties(0), periods.uncertainties(1)];
        [lengths, periods, of_both[0], of_both[1], Wanted::amplitudes(self.amplitude_unit)]
    }

    /// The column of amplitudes, or the one of all rows, or none.
    fn amplitudes(&self, column: Option<Vec<f64>>) -> Result<Vec<Quantity>, Failure> {
        let exactly = |value: f64| Quantity { value, uncertainty: None };
        match (column, self.amplitude) {
            (Some(_), Some(_)) => Err(Failure::usage(
                "--amplitude",
                "a column of amplitudes is given too: leave out one of them",
            )),
            (Some(column), None) => Ok(column.into_iter().map(exactly).collect()),
            (None, amplitude) => Ok(amplitude.map(|angle| exactly(angle.radians())).into_iter().collect()),
        }
    }

    /// The columns of length, period, their uncertainties, and amplitude.
    fn columns(&self, width: usize) -> Result<[Option<Column>; 5], Failure> {
        let first = |count| (1..=count).map(|number| Some(Column::Number(number))).collect();
        let columns: Vec<Option<Column>> = match (self.columns.len(), width) {
            (0, 2) => first(2),
            (0, 4..) => first(4),
            (2..=5, _) => self.columns.iter().map(|text| optional_column(text)).collect(),
            (0, _) => {
                let reason = format!("the table has {width} columns, not 2 or 4: say which with --columns");
                return Err(self.no_answer(reason));
            }
            (given, _) => {
                let reason = format!("{given} columns given: name 2 to 5, as in 1,2,-,3");
                return Err(Failure::usage("--columns", reason));
            }
        };
        if columns[0].is_none() || columns[1].is_none() {
            let reason = "length and period are needed: - stands only for an uncertainty";
            return Err(Failure::usage("--columns", reason));
        }
        Ok(std::array::from_fn(|index| columns.get(index).cloned().flatten()))
    }

    pub(super) fn no_answer(&self, reason: impl std::fmt::Display) -> Failure {
        Failure::no_answer(&self.name(), reason)
    }
}
