//! A result that is written sample by sample, so that long runs need little memory.

use super::ending::Ending;
use super::events::Happening;
use super::motion::SimulatedMotion;
use super::precision::Precision;
use super::resume::State;
use libration::taylor::{Moment, MomentErrors};
use std::io::{self, Write};

/// A form of the result.
pub(super) trait AnswerWriter {
    fn begin(&mut self, motion: &SimulatedMotion, out: &mut dyn Write) -> io::Result<()>;
    fn sample(&mut self, sample: &Sample, out: &mut dyn Write) -> io::Result<()>;
    /// Writes an event after all samples up to its time.
    fn event(&mut self, happening: &Happening, out: &mut dyn Write) -> io::Result<()>;
    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()>;
}

/// A state of the motion, with the values of the columns that were requested.
pub(super) struct Sample {
    pub(super) moment: Moment,
    pub(super) columns: Option<Vec<f64>>,
    /// Errors of state and columns, if they are estimated; NaN if the state is not determined.
    pub(super) errors: Option<MomentErrors>,
}

/// The summary at the end of the integration.
pub(super) struct Summary {
    pub(super) steps: usize,
    /// The drift of the energy and its uncertainty, or the reason why it is unknown.
    pub(super) drift: Result<[f64; 2], String>,
    pub(super) precision: Precision,
    pub(super) ending: Ending,
    /// State for a continuation, if it is kept.
    pub(super) state: Option<State>,
}
