//! A table of cells, and the numbers of chosen columns.

use super::dialect::{Delimiter, Dialect};
use super::heading::StatedUncertainty;
use super::options::ReadOptions;
use super::recording::{Recording, divided};
use super::sheet::Sheet;
use super::{Column, MeasurementError};

/// A rectangular table of cells, perhaps with names over its columns.
///
/// # Examples
/// ```
/// use libration_lab::measurement::{Column, ReadOptions, Table};
///
/// let table = Table::read(b"angle;period\n0,5;2,01\n1,0;\n1,5;2,31\n", &ReadOptions::default())?;
/// let chosen = table.select(&[Column::Name("Period".into())])?;
/// assert_eq!((chosen.columns[0].as_slice(), chosen.dropped), ([2.01, 2.31].as_slice(), 1));
/// # Ok::<(), libration_lab::measurement::MeasurementError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    sheet: Sheet,
    names: Vec<String>,
    /// Number of sheets in the file.
    sheets: usize,
}

/// The numbers of the chosen columns, in the rows that have them all.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// One vector for each chosen column, all of equal length.
    pub columns: Vec<Vec<f64>>,
    /// The line each row came from, counted from one.
    pub lines: Vec<u64>,
    /// Number of rows that were left out because a chosen cell is empty or NaN.
    pub dropped: usize,
}

/// Readings of quantities, in the rows that have one of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// The readings of each quantity, row by row.
    pub quantities: Vec<Vec<Vec<f64>>>,
    /// The uncertainties contained in the cells of each quantity, if all cells have one.
    pub uncertainties: Vec<Option<Vec<f64>>>,
    /// The line each row came from, counted from one.
    pub lines: Vec<u64>,
    /// The row of the table, counted from zero.
    pub rows: Vec<usize>,
    /// Number of rows that were left out because a quantity has no number.
    pub dropped: usize,
}

/// Words of rows that summarise others.
const SUMMARY: [&str; 62] = [
    "mean",
    "average",
    "avg",
    "avg.",
    "median",
    "std",
    "std.",
    "sd",
    "stdev",
    "st. dev.",
    "standard deviation",
    "sum",
    "total",
    "mittelwert",
    "mittel",
    "moyenne",
    "media",
    "standardabweichung",
    "uncertainty",
    "error",
    "ø",
    "⌀",
    "∅",
    "x̄",
    "mw",
    "moy",
    "moy.",
    "durchschnitt",
    "promedio",
    "σ",
    "summe",
    "somme",
    "somma",
    "suma",
    "s.d.",
    "écart-type",
    "écart type",
    "desviación estándar",
    "deviazione standard",
    "unsicherheit",
    "incertitude",
    "fehler",
    "u",
    "±",
    "range",
    "spannweite",
    "étendue",
    "mean value",
    "mean values",
    "slope",
    "steigung",
    "pente",
    "pendiente",
    "result",
    "ergebnis",
    "résultat",
    "gemiddelde",
    "medelvärde",
    "medel",
    "średnia",
    "média",
    "desvio padrão",
];
/// Words of them that others may follow.
const MEANS: [&str; 6] = ["mean", "average", "mittelwert", "moyenne", "media", "median"];
/// Words of rows that summarise others where both are in a table: Max is also a name.
const BOUNDS: [&str; 2] = ["max", "min"];

impl Table {
    /// The table in these bytes; of a workbook, the first sheet with two columns of numbers.
    ///
    /// # Errors
    /// Those of [`Recording::read`].
    pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Self, MeasurementError> {
        Self::read_sheet(bytes, options, None)
    }

    /// The table of a sheet, chosen by its name or its number.
    ///
    /// # Errors
    /// Those of [`Recording::read`]; no such sheet.
    pub fn read_sheet(
        bytes: &[u8],
        options: &ReadOptions,
        sheet: Option<&Column>,
    ) -> Result<Self, MeasurementError> {
        let recording = Recording::read(bytes, options)?;
        let (mut sheet, sheets) = recording.into_sheet(sheet)?;
        sheet.repeat_headings();
        sheet.join_parts();
        let named = sheet.header_line.is_some();
        let names =
            sheet.channels.iter().filter(|_| named).map(|channel| channel.heading.text.clone()).collect();
        Ok(Self { sheet, names, sheets })
    }

    /// The index of a column, from zero.
    ///
    /// # Errors
    /// No such column, or a name that several bear.
    pub fn index_of(&self, column: &Column) -> Result<usize, MeasurementError> {
        self.sheet.index_of(column)
    }

    pub(super) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The name of the sheet that is read, of a workbook with several.
    #[must_use]
    pub fn chosen_sheet(&self) -> Option<&str> {
        (self.sheets > 1).then_some(self.sheet.name.as_str())
    }

    /// Delimiter of the cells.
    #[must_use]
    pub fn delimiter(&self) -> Delimiter {
        let Dialect { delimiter, .. } = self.sheet.dialect;
        delimiter
    }

    /// The names of the columns; empty when the table has no header.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.sheet.channels.len()
    }

    /// The numbers in these columns, row by row; rows that lack one of them are dropped and counted.
    ///
    /// # Errors
    /// No such column, a name that several columns bear, a cell that is text, no complete row.
    pub fn select(&self, columns: &[Column]) -> Result<Selection, MeasurementError> {
        let indices: Vec<usize> =
            columns.iter().map(|column| self.sheet.index_of(column)).collect::<Result<_, _>>()?;
        let mut selection =
            Selection { columns: vec![Vec::new(); indices.len()], lines: Vec::new(), dropped: 0 };
        for row in self.rows() {
            match self.numbers(row, &indices)? {
                Some(numbers) => selection.push(self.sheet.lines[row], &numbers),
                None => selection.dropped += 1,
            }
        }
        if selection.lines.is_empty() {
            return Err(MeasurementError::NothingComplete(self.sheet.rows()));
        }
        Ok(selection)
    }

    /// The readings of several quantities, each in one column or more, row by row; rows without a reading of one of them are dropped and counted. A
    /// quantity without columns has no readings.
    ///
    /// # Errors
    /// Those of [`select`](Self::select).
    pub fn readings(&self, quantities: &[Vec<Column>]) -> Result<Readings, MeasurementError> {
        let indices_of =
            |columns: &Vec<Column>| columns.iter().map(|column| self.sheet.index_of(column)).collect();
        let indices: Vec<Vec<usize>> = quantities.iter().map(indices_of).collect::<Result<_, _>>()?;
        let mut readings = Readings {
            quantities: vec![vec![]; indices.len()],
            uncertainties: vec![Some(vec![]); indices.len()],
            lines: vec![],
            rows: vec![],
            dropped: 0,
        };
        for row in self.rows() {
            let of_row: Vec<Vec<f64>> =
                indices.iter().map(|columns| self.present(row, columns)).collect::<Result<_, _>>()?;
            if of_row.iter().zip(&indices).any(|(numbers, columns)| numbers.is_empty() && !columns.is_empty())
            {
                readings.dropped += 1;
                continue;
            }
            readings.push(self.sheet.lines[row], row, of_row);
            for (uncertainties, columns) in readings.uncertainties.iter_mut().zip(&indices) {
                let measured =
                    columns.first().and_then(|&column| self.sheet.channels[column].uncertainties[row]);
                match (uncertainties.as_mut(), measured) {
                    (Some(column), Some(uncertainty)) if columns.len() == 1 => column.push(uncertainty),
                    _ => *uncertainties = None,
                }
            }
        }
        match readings.lines.is_empty() {
            true => Err(MeasurementError::NothingComplete(self.sheet.rows())),
            false => Ok(readings),
        }
    }

    /// The labels of these rows in a column, such as names of groups; empty where a cell is.
    ///
    /// # Errors
    /// No such column.
    pub fn labels(&self, column: &Column, rows: &[usize]) -> Result<Vec<String>, MeasurementError> {
        let channel = &self.sheet.channels[self.sheet.index_of(column)?];
        Ok(rows.iter().map(|&row| channel.label(row).unwrap_or_default()).collect())
    }

    /// The last digit of the numbers in a column, in the unit of the column; `None` without numbers.
    ///
    /// # Errors
    /// No such column.
    pub fn step(&self, column: &Column) -> Result<f64, MeasurementError> {
        let channel = &self.sheet.channels[self.sheet.index_of(column)?];
        Ok(libm::exp10(-f64::from(channel.decimals)))
    }

    /// The uncertainty of all values of a column, if its heading states it: `T (s) ± 0.004`.
    ///
    /// # Errors
    /// No such column.
    pub fn stated_uncertainty(&self, column: &Column) -> Result<Option<StatedUncertainty>, MeasurementError> {
        Ok(self.sheet.channels[self.sheet.index_of(column)?].heading.stated_uncertainty)
    }

    /// The fraction of another quantity to which 1 corresponds in a column of relative uncertainties: 0.01 for `u(T) in %`; `None` for other
    /// columns.
    ///
    /// # Errors
    /// No such column; relative uncertainties without a sign of their unit.
    pub fn fraction(&self, column: &Column) -> Result<Option<f64>, MeasurementError> {
        let index = self.sheet.index_of(column)?;
        let heading = &self.sheet.channels[index].heading;
        if heading.is_relative_without_unit() {
            return Err(MeasurementError::RelativeWithoutUnit { location: self.sheet.describe(index) });
        }
        Ok(heading.fraction())
    }

    /// Lines of summary rows, marked by a word such as `mean`, with that word; they are left out.
    #[must_use]
    pub fn summaries(&self) -> Vec<(u64, &str)> {
        let summary = |row| Some((self.sheet.lines[row], self.summary(row)?));
        (0..self.sheet.rows()).filter_map(summary).collect()
    }

    /// Changes of the lines of the file, as sentences without a full stop: a line that was divided, rows that were left out.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let divided = self.sheet.divided_line.map(divided);
        let summary = |(line, word): (u64, &str)| {
            format!("line {line} (`{word}`) is left out: it summarises other rows")
        };
        let remarks = self.sheet.remarks.iter().cloned();
        divided.into_iter().chain(remarks).chain(self.summaries().into_iter().map(summary)).collect()
    }

    /// The word that marks a summary row.
    fn summary(&self, row: usize) -> Option<&str> {
        let plain = |word: &str| {
            let word = word.split('(').next().unwrap_or_default();
            word.trim().trim_end_matches([':', '=', '.']).trim().to_lowercase()
        };
        let words = |row: usize| (0..self.width()).filter_map(move |column| self.sheet.word(column, row));
        let has = |bound: &str| (0..self.sheet.rows()).any(|row| words(row).any(|word| plain(word) == bound));
        let is_of_summary = |word: &&str| {
            let word = plain(word);
            // `mean g`, `Mittelwert von g`
            let word = word
                .split(' ')
                .next()
                .filter(|first| MEANS.contains(first))
                .map_or(word.clone(), str::to_owned);
            SUMMARY.iter().any(|summary| summary.trim_end_matches('.') == word)
                || BOUNDS.contains(&word.as_str()) && BOUNDS.iter().all(|bound| has(bound))
        };
        // `g = ` where other rows have numbers.
        let is_label = |column: &usize| {
            let mostly_numbers = 2 * self.sheet.channels[*column].count() > self.sheet.rows();
            mostly_numbers
                && self.sheet.word(*column, row).is_some_and(|word| word.trim().ends_with(['=', ':']))
        };
        let label = || (0..self.width()).find(is_label).and_then(|column| self.sheet.word(column, row));
        words(row).rfind(is_of_summary).or_else(label)
    }

    /// The rows that summarise no others.
    fn rows(&self) -> impl Iterator<Item = usize> {
        (0..self.sheet.rows()).filter(|&row| self.summary(row).is_none())
    }

    /// The numbers in these columns of a row, without missing ones.
    fn present(&self, row: usize, columns: &[usize]) -> Result<Vec<f64>, MeasurementError> {
        let numbers: Vec<Option<f64>> =
            columns.iter().map(|&column| self.sheet.number(column, row)).collect::<Result<_, _>>()?;
        Ok(numbers.into_iter().flatten().collect())
    }

    /// The numbers of a row; `None` if one of them is missing.
    fn numbers(&self, row: usize, columns: &[usize]) -> Result<Option<Vec<f64>>, MeasurementError> {
        let numbers: Vec<Option<f64>> =
            columns.iter().map(|&column| self.sheet.number(column, row)).collect::<Result<_, _>>()?;
        Ok(numbers.into_iter().collect())
    }
}

impl Readings {
    fn push(&mut self, line: u64, row: usize, of_row: Vec<Vec<f64>>) {
        self.lines.push(line);
        self.rows.push(row);
        for (quantity, numbers) in self.quantities.iter_mut().zip(of_row) {
            quantity.push(numbers);
        }
    }
}

impl Selection {
    fn push(&mut self, line: u64, numbers: &[f64]) {
        self.lines.push(line);
        for (column, &number) in self.columns.iter_mut().zip(numbers) {
            column.push(number);
        }
    }
}
