//! The results at the points of a chunk.

use super::plan::Plan;
use super::point;
use crate::interrupt;
use crate::output::csv;
use std::io;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The kept fields of the result at a point, or the error: exit status and reason.
pub(crate) type PointOutcome = Result<Vec<f64>, (u8, String)>;

/// The outcomes at the points of a chunk, in their order. `None` if the run is cancelled before their end.
pub(crate) fn outcomes(plan: &Plan, chunk: usize) -> Option<Vec<PointOutcome>> {
    counted_outcomes(plan, chunk, &AtomicUsize::new(0))
}

/// The same; `done` counts them.
pub(super) fn counted_outcomes(plan: &Plan, chunk: usize, done: &AtomicUsize) -> Option<Vec<PointOutcome>> {
    let outcome = |point| {
        if interrupt::is_cancelled() {
            return None;
        }
        let outcome = match point::answer(&plan.words(point)) {
            Ok(answer) => Ok(plan.numbers(&answer)),
            Err(error) if error.is_cancelled() => return None,
            Err(failure) => Err((failure.status(), point::reason(&failure))),
        };
        done.fetch_add(1, Ordering::Relaxed);
        Some(outcome)
    };
    plan.grid.points_of(chunk).map(outcome).collect()
}

/// A line for each point, below a line of names: the indices, the numbers, status and message.
pub(crate) fn csv(plan: &Plan, chunk: usize, outcomes: &[PointOutcome]) -> io::Result<Vec<u8>> {
    let mut text = header(plan)?;
    let columns = plan.columns().len();
    for (point, outcome) in plan.grid.points_of(chunk).zip(outcomes) {
        let indices = plan.grid.indices_of(point);
        let mut cells: Vec<String> =
            plan.axes.iter().zip(indices).map(|(axis, index)| axis.shown(index)).collect();
        match outcome {
            Ok(numbers) => {
                cells.extend(numbers.iter().map(|number| csv::number(*number)));
                cells.extend(["0".to_owned(), String::new()]);
            }
            Err((status, message)) => {
                cells.extend(std::iter::repeat_n(String::new(), columns));
                cells.extend([status.to_string(), message.clone()]);
            }
        }
        csv::line(&mut text, &cells)?;
    }
    Ok(text)
}

/// The first line.
pub(crate) fn header(plan: &Plan) -> io::Result<Vec<u8>> {
    let axes = plan.axes.iter().map(|axis| axis.name.clone());
    let beside = super::plan::BESIDE.map(str::to_owned);
    let mut text = vec![];
    csv::line(&mut text, &axes.chain(plan.columns()).chain(beside).collect::<Vec<_>>())?;
    Ok(text)
}
