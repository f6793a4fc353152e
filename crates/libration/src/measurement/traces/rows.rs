//! The rows of one run: complete, in the order of time, in seconds and radians.

use std::collections::BTreeMap;

use super::super::choices::{Choice, Choices, Finding};
use super::super::sheet::Sheet;
use super::super::{Faults, MeasurementError, Seen, Trace};
use super::columns::{Columns, Value};
use super::{positions, turns, units};

/// A column with more numbers than this numbers no runs.
const MOST_RUNS: usize = 1000;

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
        let mut runs = numbered(sheet, numbering)?;
        let text = format!("{} numbers {} runs", sheet.describe(numbering), runs.len());
        findings.push(Finding::new(text, Choice::Run));
        let name = |number: f64| format!("{} {number}", sheet.channels[numbering].heading.name);
        if let Some(asked) = &choices.run {
            let available = runs.iter().map(|(number, _)| number.to_string()).collect::<Vec<_>>().join(", ");
            let is =
                |number: f64, asked: &str| [number.to_string(), name(number)].contains(&asked.trim().into());
            if let Some(missing) = asked.split(',').find(|asked| !runs.iter().any(|run| is(run.0, asked))) {
                return Err(MeasurementError::NoSuch {
                    what: "run",
                    asked: missing.trim().into(),
                    available,
                });
            }
            runs.retain(|(number, _)| asked.split(',').any(|asked| is(*number, asked)));
        }
        let rows =
            |(number, rows): (f64, Vec<usize>)| Self::collect(sheet, columns, name(number), rows.into_iter());
        runs.into_iter().map(rows).collect()
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
        if let Some(&before) = self.times.last().filter(|&&before| time < before) {
            return Err(MeasurementError::TimeGoesBack { line: sheet.lines[row], before, after: time });
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
        let seen = self.scale(sheet, columns, choices, &mut tell)?;
        if seen == Seen::Angle {
            turns::unwrap(&mut self.values, &self.name, &mut tell);
        }
        let faults = self.faults(sheet, seen, &mut tell);
        let repeated = faults.left_out();
        let kept: Vec<usize> =
            (0..self.rows.len()).filter(|row| repeated.binary_search(row).is_err()).collect();
        let of_kept = |column: &[f64]| kept.iter().map(|&row| column[row]).collect::<Vec<f64>>();
        let uncertainties = columns.uncertainty.map(|_| of_kept(&self.uncertainties));
        let trace = Trace::new(&self.name, seen, of_kept(&self.times), of_kept(&self.values), uncertainties)?;
        Ok((trace, kept.iter().map(|&row| sheet.lines[self.rows[row]]).collect()))
    }

    fn scale(
        &mut self,
        sheet: &Sheet,
        columns: &Columns,
        choices: &Choices,
        tell: &mut impl FnMut(Finding),
    ) -> Result<Seen, MeasurementError> {
        let (place, seen) = match columns.value {
            Value::Column(place, seen) => (place, seen),
            Value::Positions { x, y } => {
                positions::same_unit(sheet, x, y)?;
                self.values =
                    positions::angles(&self.values, &self.heights, choices.pivot, &self.name, tell)?;
                return Ok(Seen::Angle);
            }
        };
        let scale = units::of_value(&self.values, sheet, place, seen, choices, tell)?;
        self.values.iter_mut().for_each(|value| *value = scale.of(*value));
        if let Some(place) = columns.uncertainty {
            let scale = units::of_uncertainty(sheet, place, scale, choices);
            self.uncertainties.iter_mut().for_each(|value| *value = scale.of(*value));
        }
        Ok(seen)
    }

    /// Tells of the rows that are left out and of what is strange in the others.
    fn faults(&self, sheet: &Sheet, seen: Seen, tell: &mut impl FnMut(Finding)) -> Faults {
        let run = if self.name.is_empty() { String::new() } else { format!("{}: ", self.name) };
        if self.incomplete > 0 {
            let rows = if self.incomplete == 1 { "row" } else { "rows" };
            tell(Finding::fact(format!("{run}{} incomplete {rows} left out", self.incomplete)));
        }
        let faults = Faults::find(&self.times, &self.values, None);
        let lines: Vec<u64> = self.rows.iter().map(|&row| sheet.lines[row]).collect();
        let unit = if seen == Seen::Angle { "rad" } else { "rad/s" };
        faults
            .sentences(&lines, unit)
            .into_iter()
            .for_each(|text| tell(Finding::fact(format!("{run}{text}"))));
        faults
    }
}

/// The rows of each number in this column, in the order in which the numbers come.
fn numbered(sheet: &Sheet, numbering: usize) -> Result<Vec<(f64, Vec<usize>)>, MeasurementError> {
    let mut runs: Vec<(f64, Vec<usize>)> = Vec::new();
    let mut places: BTreeMap<u64, usize> = BTreeMap::new();
    for row in 0..sheet.rows() {
        let Some(number) = sheet.number(numbering, row)? else { continue };
        let place = *places.entry(number.to_bits()).or_insert(runs.len());
        if place == runs.len() {
            runs.push((number, Vec::new()));
        }
        runs[place].1.push(row);
    }
    if runs.len() > MOST_RUNS {
        let place = sheet.describe(numbering);
        return Err(MeasurementError::TooMany { what: "runs", count: runs.len(), place, limit: MOST_RUNS });
    }
    Ok(runs)
}

/// What became of a row.
enum Taken {
    Whole,
    Part,
    Blank,
}
