//! The chunks of a shard, on all cores.

use super::chunk;
use super::shard::Shard;
use super::store::Store;
use crate::query_error::QueryError;
use crate::{interrupt, parallel};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Computes and writes the missing chunks of a shard.
pub(crate) fn run(store: &Store, shard: Shard) -> Result<(), QueryError> {
    store.note(shard)?;
    let grid = &store.plan.grid;
    let mut missing = vec![];
    for chunk in shard.chunks(grid.chunks()) {
        if !store.has(chunk)? {
            missing.push(chunk);
        }
    }
    let all: usize = missing.iter().map(|chunk| grid.points_of(*chunk).len()).sum();
    let (done, failed) = (AtomicUsize::new(0), AtomicBool::new(false));
    let work = |chunk: &usize| {
        if failed.load(Ordering::Relaxed) {
            return Ok(());
        }
        let Some(outcomes) = chunk::counted_outcomes(&store.plan, *chunk, &done) else { return Ok(()) };
        let written = store.write(*chunk, &outcomes);
        failed.fetch_or(written.is_err(), Ordering::Relaxed);
        written
    };
    let how_far = || format!("{} of {all} points", done.load(Ordering::Relaxed));
    let written = parallel::with_progress(how_far, || parallel::map(&missing, work));
    let ended = |reason: String, whole: usize| {
        format!(
            "{reason}; {whole} of {} chunks are complete, and the same command continues from there",
            missing.len()
        )
    };
    let whole = missing.iter().filter(|chunk| store.has(**chunk).unwrap_or(false)).count();
    match written.into_iter().collect::<Result<(), _>>() {
        Err(failure) => Err(QueryError::failed(ended(failure.to_string(), whole))),
        Ok(()) if interrupt::is_cancelled() => {
            Err(QueryError::cancelled(ended("interrupted".to_owned(), whole)))
        }
        Ok(()) => Ok(()),
    }
}
