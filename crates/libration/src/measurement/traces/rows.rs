//! The rows of one run: complete, in the order of time, in seconds and radians.

use super::super::choices::{Choice, Choices, Finding};
use super::super::sheet::Sheet;
use super::super::{MeasurementError, Seen, Trace};
use super::columns::{Columns, Value};
use super::{turns, units};

/// Some rows of a sheet, as columns of what the file holds.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    name: String,
    /// From zero.
    rows: Vec<usize>,
    times: Vec<f64>,
    values: Vec<f64>,
    /// The vertical positions, where the values are the horizontal ones.
    heights: Vec<f64>,
    uncertainties: Vec<f64>,
    incomplete: usize,
    repeated: usize,
}

impl Rows {
    /// The complete rows, one set for each number in the column that numbers runs.
    pub(super) fn of_runs(
        sheet: &Sheet,
        columns: &Columns,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Vec<Self>, MeasurementError> {
        let Some(numbering) = columns.numbering else {
            let name = columns.run.clone().unwrap_or_else(|| sheet.name.clone());
            return Ok(vec![Self::collect(sheet, columns, name, 0..sheet.rows())?]);
        };
        let mut runs: Vec<(f64, Vec<usize>)> = Vec::new();
        for row in 0..sheet.rows() {
            let Some(number) = sheet.number(numbering, row)? else { continue };
            match runs.last_mut().filter(|(last, _)| *last == number) {
                Some((_, rows)) => rows.push(row),
                None => runs.push((number, vec![row])),
            }
        }
        let name = |number: f64| format!("{} {number}", sheet.channels[numbering].heading.name);
        let text = format!("{} numbers {} runs", sheet.describe(numbering), runs.len());
        findings.push(Finding::new(text, Choice::Run));
        if let Some(asked) = &choices.run {
            let available = runs.iter().map(|(number, _)| number.to_string()).collect::<Vec<_>>().join(", ");
            runs.retain(|(number, _)| number.to_string() == asked.trim() || name(*number) == asked.trim());
            if runs.is_empty() {
                return Err(MeasurementError::NoSuch { what: "run", asked: asked.clone(), available });
            }
        }
        runs.into_iter()
            .map(|(number, rows)| Self::collect(sheet, columns, name(number), rows.into_iter()))
            .collect()
    }

    fn collect(
        sheet: &Sheet,
        columns: &Columns,
        name: String,
        rows: impl Iterator<Item = usize>,
    ) -> Result<Self, MeasurementError> {
        let mut found = Self { name, ..Self::default() };
        let mut blank = 0;
        for row in rows {
            match found.take(sheet, columns, row)? {
                Taken::Whole => {
                    found.incomplete += blank;
                    blank = 0;
                }
                // Blank rows at the end are where a shorter run ends.
                Taken::Blank => blank += 1,
                Taken::Part => found.incomplete += 1,
            }
        }
        if found.rows.is_empty() {
            return Err(MeasurementError::NothingComplete(sheet.rows()));
        }
        Ok(found)
    }

    fn take(&mut self, sheet: &Sheet, columns: &Columns, row: usize) -> Result<Taken, MeasurementError> {
        let (value, height) = match columns.value {
            Value::Column(value, _) => (value, None),
            Value::Positions { x, y } => (x, Some(y)),
        };
        let time = sheet.number(columns.time, row)?;
        let value = sheet.number(value, row)?;
        let others = [height, columns.uncertainty]
            .map(|place| place.map(|place| sheet.number(place, row)).transpose());
        let [height, uncertainty] = others;
        let (height, uncertainty) = (height?, uncertainty?);
        let is_blank = time.is_none() && value.is_none();
        let (Some(time), Some(value), false, false) =
            (time, value, height == Some(None), uncertainty == Some(None))
        else {
            return Ok(if is_blank { Taken::Blank } else { Taken::Part });
        };
        if let Some(&before) = self.times.last().filter(|&&before| time <= before) {
            if time < before {
                return Err(MeasurementError::TimeGoesBack { line: sheet.lines[row], before, after: time });
            }
            self.repeated += 1;
            return Ok(Taken::Whole);
        }
        self.rows.push(row);
        self.times.push(time);
        self.values.push(value);
        self.heights.extend(height.flatten());
        self.uncertainties.extend(uncertainty.flatten());
        Ok(Taken::Whole)
    }

    /// The trace in seconds and radians, and the line of each row.
    pub(super) fn trace(
        mut self,
        sheet: &Sheet,
        columns: &Columns,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<(Trace, Vec<u64>), MeasurementError> {
        let mut tell = |finding: Finding| {
            if !findings.contains(&finding) {
                findings.push(finding);
            }
        };
        units::seconds(&mut self.times, sheet, columns.time, choices, &mut tell)?;
        let Value::Column(place, seen) = columns.value else {
            return Err(MeasurementError::NothingComplete(0));
        };
        let scale = units::of_value(&self.values, sheet, place, seen, choices, &mut tell)?;
        self.values.iter_mut().for_each(|value| *value = scale.of(*value));
        self.uncertainties.iter_mut().for_each(|value| *value = scale.of(*value));
        if seen == Seen::Angle {
            turns::unwrap(&mut self.values, &self.name, &mut tell);
        }
        self.tell_of_rows(&mut tell);
        let uncertainties = columns.uncertainty.map(|_| self.uncertainties);
        let lines = self.rows.iter().map(|&row| sheet.lines[row]).collect();
        Ok((Trace::new(&self.name, seen, self.times, self.values, uncertainties)?, lines))
    }

    fn tell_of_rows(&self, tell: &mut impl FnMut(Finding)) {
        let run = if self.name.is_empty() { String::new() } else { format!("{}: ", self.name) };
        if self.incomplete > 0 {
            tell(Finding::fact(format!("{run}{} incomplete rows left out", self.incomplete)));
        }
        if self.repeated > 0 {
            tell(Finding::fact(format!(
                "{run}{} rows left out that repeat the time before them",
                self.repeated
            )));
        }
    }
}

/// What became of a row.
enum Taken {
    Whole,
    Part,
    Blank,
}
