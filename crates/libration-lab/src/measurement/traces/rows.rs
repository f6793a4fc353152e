//! The rows of one run: complete, in the order of time, in seconds and radians.

use std::collections::BTreeMap;

use super::super::choices::{Choice, Choices, Finding};
use super::super::sheet::Sheet;
use super::super::{Faults, FittedPivot, MeasurementError, Observable, Trace};
use super::columns::Columns;
use super::sequence::Sequence;
use super::value::Value;
use super::{positions, runs, stamps, turns, units};

/// A column with more numbers than this numbers no runs.
const MOST_RUNS: usize = 1000;

/// Some rows of a sheet, as columns of the file.
#[derive(Clone, Debug, Default)]
pub(super) struct RunRows {
    name: String,
    /// Numbers of the rows, from zero.
    rows: Vec<usize>,
    times: Vec<f64>,
    /// One for each column that the values are made of.
    columns: Vec<Vec<f64>>,
    /// Values made from the columns, after scaling.
    values: Vec<f64>,
    uncertainties: Vec<f64>,
    /// Pivot about which the values are angles, where it was fitted.
    pivot: Option<FittedPivot>,
    incomplete: usize,
}

impl RunRows {
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
        let indices = columns.value.places();
        let mut run = Self { name, columns: vec![Vec::new(); indices.len()], ..Self::default() };
        let mut blank = 0;
        for row in rows {
            match run.take(sheet, columns, &indices, row)? {
                Taken::Whole => {
                    run.incomplete += blank;
                    blank = 0;
                }
                // Blank rows at the end are where a shorter run ends.
                Taken::Blank => blank += 1,
                Taken::Part => run.incomplete += 1,
            }
        }
        if run.rows.is_empty() {
            return Err(MeasurementError::NothingComplete(sheet.rows()));
        }
        Ok(run)
    }

    fn take(
        &mut self,
        sheet: &Sheet,
        columns: &Columns,
        indices: &[usize],
        row: usize,
    ) -> Result<Taken, MeasurementError> {
        let time = sheet.number(columns.time, row)?;
        let values: Vec<Option<f64>> =
            indices.iter().map(|&column| sheet.number(column, row)).collect::<Result<_, _>>()?;
        let uncertainty = columns.uncertainty.map(|column| sheet.number(column, row)).transpose()?;
        let is_blank = time.is_none() && values[0].is_none();
        let (Some(time), Some(values), false) =
            (time, values.into_iter().collect::<Option<Vec<f64>>>(), uncertainty == Some(None))
        else {
            return Ok(if is_blank { Taken::Blank } else { Taken::Part });
        };
        self.rows.push(row);
        self.times.push(time);
        self.columns.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
        self.uncertainties.extend(uncertainty.flatten());
        Ok(Taken::Whole)
    }

    /// The traces in seconds and radians, one for each setting of the clock, and the line of each row.
    pub(super) fn traces(
        mut self,
        sheet: &Sheet,
        columns: &Columns,
        choices: &Choices,
        findings: &mut Vec<Finding>,
    ) -> Result<Vec<(Trace, Vec<u64>)>, MeasurementError> {
        let mut tell = |finding: Finding| {
            if !findings.contains(&finding) {
                findings.push(finding);
            }
        };
        if self.incomplete > 0 {
            let rows = if self.incomplete == 1 { "row" } else { "rows" };
            tell(Finding::fact(format!("{}{} incomplete {rows} left out", self.run(), self.incomplete)));
        }
        let unit = units::of_times(&self.times, sheet, columns.time, choices, &mut tell)?;
        self.keep_between(unit, choices)?;
        let sequence = self.sequence(sheet)?;
        self.times.iter_mut().for_each(|time| *time = unit.to_si(*time));
        let observable = self.scale(sheet, columns, choices, &mut tell)?;
        let lines: Vec<u64> = self.rows.iter().map(|&row| sheet.lines[row]).collect();
        sequence.findings(&self.run(), &lines).into_iter().for_each(&mut tell);
        let mut traces: Vec<(Trace, Vec<u64>)> = Vec::new();
        for piece in self.pieces(&sequence, choices)? {
            let (trace, rows) =
                piece.trace(sheet, observable, columns.uncertainty.is_some(), choices, &mut tell)?;
            let is_same = |other: &Trace| other.times() == trace.times() && other.values() == trace.values();
            match traces.iter().find(|(other, _)| is_same(other)) {
                Some((other, _)) => {
                    let text = format!("{} repeats {} row by row: left out", trace.name(), other.name());
                    tell(Finding::fact(text));
                }
                None => traces.push((trace, rows)),
            }
        }
        Ok(traces)
    }

    fn run(&self) -> String {
        if self.name.is_empty() { String::new() } else { format!("{}: ", self.name) }
    }

    /// The selected rows, in this order.
    fn chosen(&self, name: String, rows: &[usize]) -> Self {
        let of = |column: &Vec<f64>| -> Vec<f64> {
            if column.is_empty() { Vec::new() } else { rows.iter().map(|&row| column[row]).collect() }
        };
        Self {
            name,
            rows: rows.iter().map(|&row| self.rows[row]).collect(),
            times: of(&self.times),
            columns: self.columns.iter().map(of).collect(),
            values: of(&self.values),
            uncertainties: of(&self.uncertainties),
            pivot: self.pivot.as_ref().map(|pivot| pivot.of_rows(rows)),
            incomplete: self.incomplete,
        }
    }

    /// Leaves out rows before and after the requested times.
    fn keep_between(&mut self, unit: units::Scale, choices: &Choices) -> Result<(), MeasurementError> {
        let (from, to) = (choices.from.unwrap_or(f64::NEG_INFINITY), choices.to.unwrap_or(f64::INFINITY));
        let is_between = |row: &usize| (from..=to).contains(&unit.to_si(self.times[*row]));
        let kept: Vec<usize> = (0..self.rows.len()).filter(is_between).collect();
        if kept.is_empty() {
            let [first, last] = [f64::min, f64::max]
                .map(|end| unit.to_si(self.times.iter().copied().reduce(end).unwrap_or(f64::NAN)));
            return Err(MeasurementError::NothingBetween { run: self.run(), first, last });
        }
        *self = self.chosen(self.name.clone(), &kept);
        Ok(())
    }

    fn sequence(&self, sheet: &Sheet) -> Result<Sequence, MeasurementError> {
        Sequence::new(&self.times).map_err(|row| MeasurementError::TimeGoesBack {
            line: sheet.lines[self.rows[row]],
            before: self.times[row - 1],
            after: self.times[row],
        })
    }

    /// The rows between settings of the clock, as separate runs if there are several.
    fn pieces(&self, sequence: &Sequence, choices: &Choices) -> Result<Vec<Self>, MeasurementError> {
        let asked = choices.run.as_ref().filter(|_| self.name.is_empty());
        match (&sequence.pieces[..], asked) {
            ([_], Some(asked)) => {
                let available = "one run only".to_owned();
                return Err(MeasurementError::NoSuch { what: "run", asked: asked.clone(), available });
            }
            ([piece], None) => return Ok(vec![self.chosen(self.name.clone(), piece)]),
            _ => {}
        }
        let name = |number: usize| match self.name.is_empty() {
            true => format!("run {number}"),
            false => format!("{}, part {number}", self.name),
        };
        let pieces = sequence.pieces.iter().zip(1..).map(|(piece, number)| self.chosen(name(number), piece));
        let mut pieces: Vec<Self> = pieces.collect();
        if let Some(asked) = asked {
            let available =
                pieces.iter().map(|piece| format!("`{}`", piece.name)).collect::<Vec<_>>().join(", ");
            let is_asked = |piece: &Self| asked.split(',').any(|asked| runs::is_run(&piece.name, asked));
            pieces.retain(is_asked);
            if pieces.is_empty() {
                return Err(MeasurementError::NoSuch { what: "run", asked: asked.clone(), available });
            }
        }
        Ok(pieces)
    }

    /// The trace between two settings of the clock: without faults, and with the chosen times.
    fn trace(
        mut self,
        sheet: &Sheet,
        observable: Observable,
        has_uncertainties: bool,
        choices: &Choices,
        tell: &mut impl FnMut(Finding),
    ) -> Result<(Trace, Vec<u64>), MeasurementError> {
        if observable == Observable::Angle {
            turns::unwrap(&mut self.values, &self.name, tell);
        }
        let clock_uncertainty =
            match stamps::even(&self.times, &self.values, choices.stamps, &self.run(), tell)? {
                Some(even) => {
                    self.times = even.times;
                    even.relative_uncertainty
                }
                None => 0.0,
            };
        let faults = self.faults(sheet, observable, tell);
        let repeated = faults.left_out();
        let kept: Vec<usize> =
            (0..self.rows.len()).filter(|row| repeated.binary_search(row).is_err()).collect();
        let Self { name, rows, times, values, uncertainties, pivot, .. } =
            self.chosen(self.name.clone(), &kept);
        let uncertainties = has_uncertainties.then_some(uncertainties);
        let trace = Trace::new(&name, observable, times, values, uncertainties)?
            .with_clock_uncertainty(clock_uncertainty);
        let trace = match pivot {
            Some(pivot) => trace.with_fitted_pivot(pivot)?,
            None => trace,
        };
        Ok((trace, rows.iter().map(|&row| sheet.lines[row]).collect()))
    }

    fn scale(
        &mut self,
        sheet: &Sheet,
        columns: &Columns,
        choices: &Choices,
        tell: &mut impl FnMut(Finding),
    ) -> Result<Observable, MeasurementError> {
        let (index, observable) = match columns.value {
            Value::Column(column, observable) => {
                self.values = self.columns[0].clone();
                (column, observable)
            }
            Value::Axes(axes, axis) => {
                let rate =
                    |row: usize| self.columns.iter().zip(axis).map(|(rates, part)| part * rates[row]).sum();
                self.values = (0..self.rows.len()).map(rate).collect();
                (axes[0], Observable::AngularVelocity)
            }
            Value::Positions { x, y } => {
                positions::same_unit(sheet, x, y)?;
                (self.values, self.pivot) =
                    positions::angles(&self.columns[0], &self.columns[1], choices.pivot, &self.name, tell)?;
                return Ok(Observable::Angle);
            }
        };
        let scale = units::of_value(&self.values, sheet, index, observable, choices, tell)?;
        self.values.iter_mut().for_each(|value| *value = scale.to_si(*value));
        if let Some(column) = columns.uncertainty {
            let scale = units::of_uncertainty(sheet, column, scale, choices);
            self.uncertainties.iter_mut().for_each(|value| *value = scale.to_si(*value));
        }
        Ok(observable)
    }

    /// Reports the faults of the rows.
    fn faults(&self, sheet: &Sheet, observable: Observable, tell: &mut impl FnMut(Finding)) -> Faults {
        let run = self.run();
        let faults = Faults::detect(&self.times, &self.values, None);
        let lines: Vec<u64> = self.rows.iter().map(|&row| sheet.lines[row]).collect();
        let unit = if observable == Observable::Angle { "rad" } else { "rad/s" };
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
    let mut run_indices: BTreeMap<u64, usize> = BTreeMap::new();
    for row in 0..sheet.rows() {
        let Some(number) = sheet.number(numbering, row)? else { continue };
        let run = *run_indices.entry(number.to_bits()).or_insert(runs.len());
        if run == runs.len() {
            runs.push((number, Vec::new()));
        }
        runs[run].1.push(row);
    }
    if runs.len() > MOST_RUNS {
        let location = sheet.describe(numbering);
        return Err(MeasurementError::TooMany {
            what: "runs",
            count: runs.len(),
            location,
            limit: MOST_RUNS,
        });
    }
    Ok(runs)
}

/// Completeness of a row.
enum Taken {
    Whole,
    Part,
    Blank,
}
