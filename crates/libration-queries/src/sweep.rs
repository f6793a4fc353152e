//! Sweeps for programs that keep the results themselves: the plan, and the kept numbers of the points of a chunk.

use crate::call::{self, Call};
use crate::command::{self, SweepAxis, SweepPlanned, SweepRequest};
use crate::host::Host;
use crate::query_error::{QueryError, option};
use std::fmt::Display;
use std::sync::Arc;

/// The command and the kept fields of a sweep as data, enough to compute any of its chunks anywhere.
///
/// # Examples
/// ```
/// use libration_queries::{AxisValues, Host, SweepPlan};
/// use std::io;
/// use std::sync::Arc;
///
/// struct Silent;
///
/// impl Host for Silent {
///     fn write(&self, _: &[u8]) -> io::Result<()> {
///         Ok(())
///     }
/// }
///
/// let axes = [("amplitude".to_owned(), AxisValues::Text("60deg,90deg".to_owned()))];
/// let keep = ["results[0].ratio".to_owned()];
/// let plan = SweepPlan::new(&["period".to_owned()], &axes, &keep, None, Arc::new(Silent))?;
/// let second = SweepPlan::from_json(&plan.to_json())?.answers(1, Arc::new(Silent))?;
/// assert!((second.numbers[0] - 1.180340599016096).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SweepPlan(SweepPlanned);

/// The values of an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AxisValues {
    /// Text of `--over` after the name: `1:1.5:0.01` or `60deg,90deg`.
    Text(String),
    /// Each as the question is given it.
    List(Vec<String>),
}

/// The kept fields at the points of a chunk, which are in the order of the grid: the last axis varies fastest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepChunk {
    /// The numbers of the first point, then of the next; NaN for missing ones.
    pub numbers: Vec<f64>,
    /// Status of each point: 0 with a result, or the exit status without.
    pub status: Vec<u8>,
    /// Error message of each point; empty if there is a result.
    pub messages: Vec<String>,
}

impl SweepPlan {
    /// The plan of a question, given as the words of a command line, over these axes. Some points are asked until one has a result.
    ///
    /// `keep` names numbers of the results as `--keep` does; all that stand alone where it is empty. `chunk` is how many points a chunk has
    /// at most.
    ///
    /// # Errors
    /// Where axes, question and what is kept do not fit, and where no point that was asked has a result.
    pub fn new(
        question: &[String],
        axes: &[(String, AxisValues)],
        keep: &[String],
        chunk: Option<usize>,
        host: Arc<dyn Host>,
    ) -> Result<Self, QueryError> {
        call::within(&Call::new(vec![], host), || {
            let axes = axes.iter().map(|(name, values)| axis(name, values)).collect::<Result<_, _>>()?;
            SweepPlanned::new(SweepRequest { question, axes, keep, chunk }).map(Self)
        })
    }

    /// The plan that [`SweepPlan::to_json`] has written.
    ///
    /// # Errors
    /// Where it has another format, or is none.
    pub fn from_json(text: &str) -> Result<Self, QueryError> {
        let refused = |reason: &dyn Display| QueryError::failed(format!("the plan of the sweep: {reason}"));
        let json = serde_json::from_str(text).map_err(|error| refused(&error))?;
        SweepPlanned::read(&json).map(Self).map_err(|reason| refused(&reason))
    }

    /// The plan as text, the same for the same plan: format, version of the program, command, axes, kept fields, shape of the grid and of a chunk.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::Value::from(self.0.to_json()).to_string()
    }

    /// The kept fields at the points of a chunk, one after the other on this thread.
    ///
    /// # Errors
    /// Where there is no such chunk, and an error that is cancelled where the host has ended the work early.
    pub fn answers(&self, chunk: usize, host: Arc<dyn Host>) -> Result<SweepChunk, QueryError> {
        let plan = &self.0;
        if chunk >= plan.grid.chunks() {
            let reason = format!("there is no chunk {chunk}: the sweep has {}", plan.grid.chunks());
            return Err(QueryError::misuse(reason));
        }
        let outcomes = call::within(&Call::new(vec![], host), || command::sweep_outcomes(plan, chunk));
        let outcomes = outcomes.ok_or_else(|| QueryError::cancelled("interrupted"))?;
        let (columns, mut answers) = (plan.columns().len(), SweepChunk::default());
        for outcome in outcomes {
            let (numbers, (status, message)) = match outcome {
                Ok(numbers) => (numbers, (0, String::new())),
                Err(none) => (vec![f64::NAN; columns], none),
            };
            answers.numbers.extend(numbers);
            answers.status.push(status);
            answers.messages.push(message);
        }
        Ok(answers)
    }
}

fn axis(name: &str, values: &AxisValues) -> Result<SweepAxis, QueryError> {
    let axis = match values {
        AxisValues::Text(text) => command::sweep_axis(&format!("{name}={text}")),
        AxisValues::List(values) => SweepAxis::of_words(name, values.clone()),
    };
    axis.map_err(|reason| QueryError::usage(option("over"), reason))
}
