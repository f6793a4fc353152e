//! Result for a file: its tables, the proposed fit, and the reasons if there is none.

use crate::arguments::TableFit;
use libration_lab::measurement::{
    Choice, Choices, Clock, Faults, Finding, Gates, MeasurementError, Recording, Trace, Traces,
};

/// A file with all that is inferred from it.
pub(super) struct InspectResult {
    pub(super) file: String,
    pub(super) bytes: usize,
    pub(super) recording: Recording,
    pub(super) traces: Result<Traces, MeasurementError>,
    /// The times of a photogate, where the file has some.
    pub(super) gates: Option<Gates>,
    /// The refusal of the times of a photogate, if the file contains signals in which passages are found.
    pub(super) signals: Option<MeasurementError>,
    /// The fit of a table of periods, if the file contains neither traces nor times of a gate.
    pub(super) table_fit: Option<TableFit>,
    /// `true` if the numbers are listed too.
    pub(super) with_values: bool,
}

impl InspectResult {
    pub(super) fn new(file: String, bytes: usize, recording: Recording, choices: &Choices) -> Self {
        let traces = recording.traces(choices);
        let (gates, signals) = match &traces {
            Ok(_) => (None, None),
            Err(_) => match recording.gate_times(choices) {
                Ok(gates) => (Some(gates).filter(|gates| is_of_a_gate(&recording, gates)), None),
                Err(error) => (None, Some(error).filter(suggests_signals)),
            },
        };
        Self { file, bytes, recording, traces, gates, signals, table_fit: None, with_values: false }
    }

    /// The findings in reading, and in searching for traces or the times of a gate.
    pub(super) fn findings(&self) -> Vec<Finding> {
        let mut findings = self.recording.findings();
        match (&self.traces, &self.gates) {
            (Ok(traces), _) => findings.extend(traces.findings.clone()),
            (Err(_), Some(gates)) => findings.extend(gates.findings.clone()),
            (Err(_), None) => {}
        }
        findings
    }
}

/// Returns `true` for states of a gate, or for nothing but times.
fn is_of_a_gate(recording: &Recording, gates: &Gates) -> bool {
    let increases = gates.times.windows(2).all(|pair| pair[0] < pair[1]);
    let is_alone = recording.sheets().iter().any(|sheet| sheet.channels.len() == 1);
    gates.times.len() > 1 && increases && (gates.blocked.is_some() || is_alone)
}

fn suggests_signals(error: &MeasurementError) -> bool {
    match error {
        MeasurementError::Undecided { choices, .. } => {
            choices.iter().any(|choice| choice.choice == Choice::Signal)
        }
        _ => false,
    }
}

/// The clock of a trace: the intervals between its times.
pub(super) fn clock(trace: &Trace) -> Option<Clock> {
    Faults::detect(trace.times(), trace.values(), None).clock
}

/// The smallest and the largest value.
pub(super) fn range(trace: &Trace) -> (f64, f64) {
    let values = trace.values().iter();
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (low.min(value), high.max(value)))
}
