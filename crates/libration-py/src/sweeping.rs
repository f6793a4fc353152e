//! The plan of a sweep and the results of its chunks, for `sweeps.py`.

use std::io;
use std::sync::Arc;

use libration::progress::{Progress, Status};
use libration_queries::{AxisValues, Host, SweepPlan};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::asking::raised;
use crate::progress::CallProgress;

/// The values of an axis: text as on the command line, or a list.
#[derive(FromPyObject)]
pub(crate) enum Values {
    Text(String),
    List(Vec<String>),
}

impl From<Values> for AxisValues {
    fn from(values: Values) -> Self {
        match values {
            Values::Text(text) => Self::Text(text),
            Values::List(values) => Self::List(values),
        }
    }
}

/// Cancellation of a chunk by the interpreter, or by a function that raises an exception.
struct Watcher {
    progress: CallProgress,
}

impl Host for Watcher {
    fn write(&self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn goes_on(&self) -> bool {
        self.progress.update(Status::default()).is_continue()
    }
}

impl Watcher {
    fn new(go_on: Option<Py<PyAny>>) -> Arc<Self> {
        Arc::new(Self { progress: CallProgress::new(go_on) })
    }
}

/// The plan as JSON.
#[pyfunction]
#[pyo3(signature = (question, axes, keep, chunk=None))]
pub(crate) fn sweep_plan(
    py: Python<'_>,
    question: Vec<String>,
    axes: Vec<(String, Values)>,
    keep: Vec<String>,
    chunk: Option<usize>,
) -> PyResult<String> {
    let axes: Vec<(String, AxisValues)> =
        axes.into_iter().map(|(name, values)| (name, values.into())).collect();
    let watcher = Watcher::new(None);
    let plan = py.detach(|| SweepPlan::new(&question, &axes, &keep, chunk, watcher.clone()));
    let plan = plan.map_err(|failure| raised(py, &failure));
    if plan.is_err()
        && let Some(stopped) = watcher.progress.stopped_by()
    {
        return Err(stopped);
    }
    Ok(plan?.to_json())
}

/// A row of numbers for each point, the statuses, the messages.
type Answers<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<u8>>, Vec<String>);

/// The selected results of a chunk; `go_on` is called at intervals with two arguments, and stops the computation by raising an exception.
#[pyfunction]
#[pyo3(signature = (plan, chunk, go_on=None))]
pub(crate) fn sweep_chunk<'py>(
    py: Python<'py>,
    plan: &str,
    chunk: usize,
    go_on: Option<Py<PyAny>>,
) -> PyResult<Answers<'py>> {
    let watcher = Watcher::new(go_on);
    let answers = py.detach(|| SweepPlan::from_json(plan)?.answers(chunk, watcher.clone()));
    let answers = match (answers, watcher.progress.stopped_by()) {
        (Ok(answers), _) => answers,
        (Err(_), Some(stopped)) => return Err(stopped),
        (Err(failure), None) => return Err(raised(py, &failure)),
    };
    let points = answers.status.len();
    let columns = answers.numbers.len().checked_div(points).unwrap_or_default();
    let numbers = answers.numbers.into_pyarray(py).reshape([points, columns])?;
    Ok((numbers, answers.status.into_pyarray(py), answers.messages))
}
