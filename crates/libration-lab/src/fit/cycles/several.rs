//! β through the cycles of several traces of one pendulum.

use super::row::CycleRow;
use super::{Beta, Cycles, CyclesError, period_law};
use crate::measurement::{FittedPivot, Trace};
use libration::internals::progress::Watch;
use libration::progress::{Interrupted, Progress};

/// Fits β and T0 to the cycles of all traces together, or to those of the only trace. `cycles` are those of the traces,
/// one by one.
///
/// Traces about one fitted pivot share its error, so that it is added once, by its effect on the
/// common β, and does not decrease with the number of traces.
///
/// # Errors
/// Fails with the error of the first trace where none has cycles; otherwise as for a trace alone: fewer than three cycles, amplitudes that are
/// all the same or whose noise is too large compared with their change.
/// [`CyclesError::Interrupted`] if the call is cancelled.
pub fn beta_of_traces(
    traces: &[Trace],
    cycles: &[Result<Cycles, CyclesError>],
    progress: &dyn Progress,
) -> Result<Beta, CyclesError> {
    let watch = &Watch::new(progress);
    let beta = of_all_cycles(traces, cycles, watch);
    if watch.is_stopped() { Err(Interrupted.into()) } else { beta }
}

fn of_all_cycles(
    traces: &[Trace],
    cycles: &[Result<Cycles, CyclesError>],
    watch: &Watch<'_>,
) -> Result<Beta, CyclesError> {
    let measured: Vec<(&Trace, &Cycles)> = traces
        .iter()
        .zip(cycles)
        .filter_map(|(trace, cycles)| Some((trace, cycles.as_ref().ok()?)))
        .collect();
    if let ([], Some(Err(error))) = (&measured[..], cycles.first()) {
        return Err(error.clone());
    }
    if let ([(_, only)], [_]) = (&measured[..], cycles) {
        return only.beta.clone();
    }
    let rows = |of: &dyn Fn(&Trace, &Cycles) -> Vec<CycleRow>| {
        joined(measured.iter().map(|(trace, cycles)| of(trace, cycles)))
    };
    let beta_of_rows = period_law::beta(&rows(&|_, cycles| cycles.rows.clone()), watch)?;
    let errors = pivots(&measured).into_iter().flat_map(|pivot| [(pivot, 0), (pivot, 1)]);
    let with_error = |beta: Beta, (pivot, error): (&FittedPivot, usize)| {
        let moved = rows(&|trace, cycles| {
            let fitted = trace.fitted_pivot().filter(|fitted| fitted.is_shared_with(pivot));
            fitted.and(cycles.about_moved_pivot.get(error)).unwrap_or(&cycles.rows).clone()
        });
        period_law::beta(&moved, watch).map_or(beta, |moved| beta.with_error(&moved))
    };
    Ok(errors.fold(beta_of_rows, with_error))
}

/// The fitted pivots, each once.
fn pivots<'a>(measured: &[(&'a Trace, &Cycles)]) -> Vec<&'a FittedPivot> {
    let mut pivots: Vec<&FittedPivot> = vec![];
    for pivot in measured.iter().filter_map(|(trace, _)| trace.fitted_pivot()) {
        if !pivots.iter().any(|other| other.is_shared_with(pivot)) {
            pivots.push(pivot);
        }
    }
    pivots
}

/// The rows of all traces, which share no passages and no extremes.
fn joined(traces: impl Iterator<Item = Vec<CycleRow>>) -> Vec<CycleRow> {
    let mut all: Vec<CycleRow> = vec![];
    for rows in traces {
        let next = all.iter().map(CycleRow::next_number).max().unwrap_or(0);
        all.extend(rows.iter().map(|row| row.numbered_from(next)));
    }
    all
}
