//! A recording → traces: which columns, in which units, run by run.
//!
//! # Method
//! Rows out of time order are sorted in or left out, and a clock that is set back starts another run (`sequence.rs`); rows outside the requested
//! times are not judged. Times that rounding has made equal, or that are rounded to a number of significant digits, are replaced by the even times
//! that round to them (`faults/even_times.rs`); the extent of the polygon of these times, as `Trace::clock_uncertainty`, enters the uncertainty of
//! ω0. A gyroscope is read about the axis along which its three rates lie; accelerations alone give no angle, and are refused with the missing
//! information in the message.

pub(crate) mod circle;
mod columns;
pub(crate) mod gyroscope;
mod positions;
mod rows;
mod runs;
pub(crate) mod sequence;
mod stamps;
pub(crate) mod turns;
pub(super) mod units;
mod value;

use super::choices::{Choice, Choices, Finding};
use super::recording::Recording;
use super::sheet::Sheet;
use super::{MeasurementError, Trace};
use columns::Columns;
use rows::RunRows;
pub use runs::is_run;

/// The traces of a recording, with all that was inferred from the file in finding them.
#[derive(Clone, Debug, PartialEq)]
pub struct Traces {
    /// One for each run.
    pub traces: Vec<Trace>,
    /// The line of each row of each trace, counted from one.
    pub lines: Vec<Vec<u64>>,
    /// Inferences from the file.
    pub findings: Vec<Finding>,
}

impl Recording {
    /// The traces of the recording: an angle, an angular velocity or positions against time, of every run or the chosen one.
    ///
    /// # Errors
    /// No such column, sheet or run; a column, unit or pivot that the file does not decide, with the choices that would;
    /// cells that are no numbers; times that go back.
    pub fn traces(&self, choices: &Choices) -> Result<Traces, MeasurementError> {
        self.in_one_sheet(choices, |sheet| {
            let mut traces = traces_of(sheet, choices)?;
            if self.sheets().len() > 1 {
                let text = format!("the traces are those of `{}`", sheet.name);
                traces.findings.insert(0, Finding::new(text, Choice::Sheet));
            }
            Ok(traces)
        })
    }
}

fn traces_of(sheet: &Sheet, choices: &Choices) -> Result<Traces, MeasurementError> {
    let mut traces = Traces { traces: Vec::new(), lines: Vec::new(), findings: Vec::new() };
    for columns in Columns::of_runs(sheet, choices, &mut traces.findings)? {
        for rows in RunRows::of_runs(sheet, &columns, choices, &mut traces.findings)? {
            for (trace, lines) in rows.traces(sheet, &columns, choices, &mut traces.findings)? {
                traces.traces.push(trace);
                traces.lines.push(lines);
            }
        }
    }
    Ok(traces)
}
