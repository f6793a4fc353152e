//! Times at which a photogate was blocked or freed.

use super::choices::{Choice, Choices, Finding, Suggestion};
use super::faults::order::restarts;
use super::heading::{Measures, Unit};
use super::recording::Recording;
use super::sheet::Sheet;
use super::signal::SignalPassages;
use super::traces::units::{Scale, counts_frames, of_times, which_rate};
use super::{MeasurementError, QuantityKind};
use crate::statistics::lower_median;
use libration::quantity::short;

/// The times of a photogate.
#[derive(Clone, Debug, PartialEq)]
pub struct Gates {
    /// Times in seconds, in the order of the file.
    pub times: Vec<f64>,
    /// `true` for each time at which the gate became blocked, if the file states it.
    pub blocked: Option<Vec<bool>>,
    /// The line of each time, counted from one.
    pub lines: Vec<u64>,
    /// Rows without a time or a state, which are left out.
    pub incomplete: usize,
    /// Inferences from the file.
    pub findings: Vec<Finding>,
}

impl Recording {
    /// The times of a photogate: the column of times, or the only column, with the state of the gate next to it.
    ///
    /// # Errors Columns that the file does not determine, cells that are neither numbers nor states, no times, times that go back repeatedly.
    pub fn gate_times(&self, choices: &Choices) -> Result<Gates, MeasurementError> {
        self.in_one_sheet(choices, |sheet| gates_of(sheet, choices))
    }
}

fn gates_of(sheet: &Sheet, choices: &Choices) -> Result<Gates, MeasurementError> {
    let mut findings = Vec::new();
    let time = time_column(sheet, choices, &mut findings)?;
    if let Some(column) = &choices.signal {
        return gates_of_signal(sheet, time, sheet.index_of(column)?, choices, findings);
    }
    let state = state_column(sheet, choices, &mut findings)?;
    if state.is_none() && choices.time.is_none() {
        refuse_samples(sheet, time)?;
    }
    let unit = unit(sheet, time, choices, &mut findings)?;
    let mut gates = Gates {
        times: Vec::new(),
        blocked: state.map(|_| Vec::new()),
        lines: Vec::new(),
        incomplete: 0,
        findings,
    };
    for row in 0..sheet.rows() {
        let state = state.map(|column| state_at(sheet, column, row)).transpose()?;
        match (sheet.number(time, row)?.map(|time| unit.to_si(time)), state) {
            (Some(time), _) if !is_asked(time, choices) => {}
            (Some(time), None | Some(Some(_))) => {
                gates.times.push(time);
                gates.lines.push(sheet.lines[row]);
                if let (Some(blocked), Some(Some(state))) = (&mut gates.blocked, state) {
                    blocked.push(state);
                }
            }
            _ => gates.incomplete += 1,
        }
    }
    if gates.times.is_empty() {
        return Err(MeasurementError::NothingComplete(sheet.rows()));
    }
    refuse_what_is_no_clock(&gates.times)?;
    gates.refuse_restarts()?;
    Ok(gates)
}

impl Gates {
    /// Refuses times that begin anew, which in the order of time would mix the passages of both parts.
    fn refuse_restarts(&self) -> Result<(), MeasurementError> {
        match restarts(&self.times).first() {
            Some(&row) => Err(MeasurementError::GateClockRestarts {
                line: self.lines[row],
                before: self.times[row - 1],
                after: self.times[row],
            }),
            None => Ok(()),
        }
    }
}

fn is_asked(time: f64, choices: &Choices) -> bool {
    choices.from.is_none_or(|from| time >= from) && choices.to.is_none_or(|to| time <= to)
}

/// The rows of a signal with a number in both columns, at increasing times.
#[derive(Default)]
struct SignalRows {
    times: Vec<f64>,
    values: Vec<f64>,
    /// The rows of the times in the sheet.
    rows: Vec<usize>,
    incomplete: usize,
}

impl SignalRows {
    fn new(
        sheet: &Sheet,
        [time, signal]: [usize; 2],
        unit: Scale,
        choices: &Choices,
    ) -> Result<Self, MeasurementError> {
        let mut all = Self::default();
        for row in 0..sheet.rows() {
            match (sheet.number(time, row)?.map(|time| unit.to_si(time)), sheet.number(signal, row)?) {
                (Some(time), Some(_)) if !is_asked(time, choices) => {}
                (Some(time), Some(value)) if all.times.last().is_none_or(|last| *last < time) => {
                    all.times.push(time);
                    all.values.push(value);
                    all.rows.push(row);
                }
                _ => all.incomplete += 1,
            }
        }
        Ok(all)
    }

    fn passages(&self) -> Option<SignalPassages> {
        SignalPassages::in_signal(&self.times, &self.values)
    }
}

/// The edges of the passages in a continuous signal.
fn gates_of_signal(
    sheet: &Sheet,
    time: usize,
    signal: usize,
    choices: &Choices,
    mut findings: Vec<Finding>,
) -> Result<Gates, MeasurementError> {
    let all: Vec<f64> = sheet.channels[time].numbers().flatten().collect();
    let unit = of_times(&all, sheet, time, choices, &mut |finding| findings.push(finding))?;
    let read = SignalRows::new(sheet, [time, signal], unit, choices)?;
    let column = sheet.describe(signal);
    let Some(signal) = read.passages() else {
        return Err(MeasurementError::NoPassages { column });
    };
    let (count, (name, height)) =
        (signal.passages.len(), if signal.are_dips { ("dips", "depth") } else { ("peaks", "height") });
    let step = lower_median(read.times.windows(2).map(|pair| pair[1] - pair[0]).collect()).unwrap_or(0.0);
    let step = short(step, 3);
    let text = format!(
        "{count} {name} of {column}, read every {step} s, are passages, which begin and end at half of their {height}"
    );
    findings.push(Finding::new(text, Choice::Signal));
    let edges = signal.passages.iter().flat_map(|passage| passage.edges.map(|edge| (edge, passage.row)));
    let (times, lines) = edges.map(|(edge, row)| (edge, sheet.lines[read.rows[row]])).unzip();
    let blocked = Some(signal.passages.iter().flat_map(|_| [true, false]).collect());
    Ok(Gates { times, blocked, lines, incomplete: read.incomplete, findings })
}

/// Refuses times with a trace, which are not a table of a gate, and those with any other measured column if they are as evenly spaced as samples.
fn refuse_samples(sheet: &Sheet, time: usize) -> Result<(), MeasurementError> {
    let is_traced = |column: usize| {
        let heading = &sheet.channels[column].heading;
        let traced = [
            QuantityKind::Angle,
            QuantityKind::AngularVelocity,
            QuantityKind::X,
            QuantityKind::Y,
            QuantityKind::Acceleration,
        ];
        traced.contains(&heading.quantity) && !heading.is_uncertainty
    };
    let is_measured = |column: usize| {
        let channel = &sheet.channels[column];
        channel.heading.quantity == QuantityKind::Other
            && !channel.heading.is_uncertainty
            && channel.count() > 0
            && !counts_rows(&channel.numbers().flatten().collect::<Vec<_>>())
    };
    let others = (0..sheet.channels.len()).filter(|&column| column != time);
    let is_even = || has_even_steps(&sheet.channels[time].numbers().flatten().collect::<Vec<_>>());
    let traced = others.clone().find(|&column| is_traced(column));
    let candidate =
        traced.or_else(|| others.clone().find(|&column| is_measured(column)).filter(|_| is_even()));
    let Some(other) = candidate else { return Ok(()) };
    let (times, other) = (sheet.describe(time), sheet.describe(other));
    // In any unit: passages depend on the order of the times and not on their scale.
    let has_passages = |column: usize| {
        let rows = SignalRows::new(sheet, [time, column], Scale::Unit(Unit::Second), &Choices::default());
        rows.is_ok_and(|rows| rows.passages().is_some())
    };
    let is_signal = |column: &usize| {
        let quantity = sheet.channels[*column].heading.quantity;
        quantity == QuantityKind::Acceleration || is_measured(*column)
    };
    let signals = others.filter(is_signal).filter(|&column| has_passages(column));
    let signals: Vec<Suggestion> =
        signals.map(|column| Suggestion::new(Choice::Signal, (column + 1).to_string())).collect();
    let (if_they_are, choices) = match signals.is_empty() {
        true => ("; if these are", vec![Suggestion::new(Choice::Time, (time + 1).to_string())]),
        false => (" unless their column is given; for passages by the dips or peaks of a signal", signals),
    };
    Err(MeasurementError::Undecided {
        question: format!(
            "{times} stands next to {other} as in a recording of samples, whose times are not passages of a gate{if_they_are}"
        ),
        choices,
    })
}

/// Returns `true` for the numbers of the passages.
fn counts_rows(numbers: &[f64]) -> bool {
    numbers.windows(2).all(|pair| (pair[1] - pair[0]).total_cmp(&1.0).is_eq())
}

/// Returns `true` if the steps are equal to a hundredth, as those of samples. Steps between passages of a gate may be so too,
/// at the centre and for a constant amplitude; therefore another column is required.
fn has_even_steps(times: &[f64]) -> bool {
    let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let Some(usual) = lower_median(steps.clone()).filter(|_| steps.len() > 2) else { return false };
    steps.iter().filter(|&step| (step - usual).abs() > 0.01 * usual.abs()).count() * 10 < steps.len()
}

/// Refuses times that go back repeatedly: a clock may be set back once, or a row be out of place, but a column of periods goes up and down.
fn refuse_what_is_no_clock(times: &[f64]) -> Result<(), MeasurementError> {
    let (goes_back, rows) = (times.windows(2).filter(|pair| pair[1] < pair[0]).count(), times.len());
    if goes_back > usize::max(1, rows / 10) {
        return Err(MeasurementError::NotGateTimes { goes_back, rows });
    }
    Ok(())
}

fn time_column(
    sheet: &Sheet,
    choices: &Choices,
    findings: &mut Vec<Finding>,
) -> Result<usize, MeasurementError> {
    if let Some(column) = &choices.time {
        return sheet.index_of(column);
    }
    let named: Vec<usize> = (0..sheet.channels.len())
        .filter(|&column| sheet.channels[column].heading.is(QuantityKind::Time))
        .collect();
    let all: Vec<usize> = (0..sheet.channels.len()).collect();
    match (&named[..], &all[..]) {
        ([time], _) | ([], [time]) => {
            findings.push(Finding::new(
                format!("{} holds the times of the gate", sheet.describe(*time)),
                Choice::Time,
            ));
            Ok(*time)
        }
        (several, all) => {
            let open = if several.is_empty() { all } else { several };
            let question = "it is not clear which column holds the times of the gate".to_owned();
            let choices =
                open.iter().map(|column| Suggestion::new(Choice::Time, (column + 1).to_string())).collect();
            Err(MeasurementError::Undecided { question, choices })
        }
    }
}

fn state_column(
    sheet: &Sheet,
    choices: &Choices,
    findings: &mut Vec<Finding>,
) -> Result<Option<usize>, MeasurementError> {
    if let Some(column) = &choices.gate {
        return sheet.index_of(column).map(Some);
    }
    let index =
        (0..sheet.channels.len()).find(|&column| sheet.channels[column].heading.is(QuantityKind::Gate));
    if let Some(gate) = index {
        findings
            .push(Finding::new(format!("{} is the state of the gate", sheet.describe(gate)), Choice::Gate));
    }
    Ok(index)
}

/// The given unit, the one in the header, or seconds if a pendulum can have such periods.
fn unit(
    sheet: &Sheet,
    column: usize,
    choices: &Choices,
    findings: &mut Vec<Finding>,
) -> Result<Scale, MeasurementError> {
    if let Some(rate) = choices.frame_rate {
        return Ok(Scale::Frames(rate));
    }
    let heading = &sheet.channels[column].heading;
    let (unit, why) = match (choices.time_unit, heading.unit, &heading.unit_text) {
        (Some(unit), ..) => return of_time(unit).map(Scale::Unit),
        (None, Some(unit), _) => (of_time(unit)?, "as the header says"),
        (None, None, None) if counts_frames(sheet, column) => return Err(which_rate(sheet, column)),
        (None, None, None) => {
            refuse_unlikely_seconds(sheet, column)?;
            (Unit::Second, "since no unit is written")
        }
        (None, None, Some(text)) => {
            return Err(which_unit(format!("`{text}` is not a known unit of time")));
        }
    };
    findings.push(Finding::new(format!("times are in {unit}, {why}"), Choice::TimeUnit));
    Ok(Scale::Unit(unit))
}

fn which_unit(question: String) -> MeasurementError {
    let choices = ["s", "ms", "us", "min"].map(|unit| Suggestion::new(Choice::TimeUnit, unit)).to_vec();
    MeasurementError::Undecided { question, choices }
}

/// Half periods of pendulums, in seconds: of one of 2.5 mm, and of one of 3.6 km.
const HALF_PERIODS: std::ops::RangeInclusive<f64> = 0.05..=60.0;

/// Refuses seconds if the steps are impossible half periods: the larger half of the steps are half periods, for passages and edges alike.
fn refuse_unlikely_seconds(sheet: &Sheet, column: usize) -> Result<(), MeasurementError> {
    let mut times: Vec<f64> = sheet.channels[column].numbers().flatten().collect();
    times.sort_by(f64::total_cmp);
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    match steps.get(3 * steps.len() / 4) {
        Some(step) if !HALF_PERIODS.contains(step) => Err(which_unit(format!(
            "the unit of time of {} is not given, and half periods of {step} s are not likely",
            sheet.describe(column)
        ))),
        _ => Ok(()),
    }
}

fn of_time(unit: Unit) -> Result<Unit, MeasurementError> {
    match unit.measures() {
        Measures::Time => Ok(unit),
        _ => Err(MeasurementError::WrongUnit { unit, of: "time", examples: "s, ms, us, min" }),
    }
}

/// `1`, `blocked` → blocked; `0`, `unblocked`, `open` → free.
fn state_at(sheet: &Sheet, column: usize, row: usize) -> Result<Option<bool>, MeasurementError> {
    match sheet.word(column, row).map(str::to_lowercase).as_deref() {
        Some("blocked" | "closed" | "true" | "on") => return Ok(Some(true)),
        Some("unblocked" | "open" | "free" | "false" | "off") => return Ok(Some(false)),
        _ => {}
    }
    match sheet.number(column, row)? {
        None => Ok(None),
        Some(1.0) => Ok(Some(true)),
        Some(0.0) => Ok(Some(false)),
        Some(other) => Err(MeasurementError::NotAState { line: sheet.lines[row], value: other }),
    }
}
