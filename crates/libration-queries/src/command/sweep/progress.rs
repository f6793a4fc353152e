//! Progress of a sweep: the complete chunks, and the missing shards.

use super::shard::Shard;
use super::store::Store;
use crate::query_error::QueryError;
use std::collections::BTreeSet;

/// The chunks of a sweep in some directories.
#[derive(Debug)]
pub(crate) struct SweepProgress {
    pub(crate) chunks: usize,
    pub(crate) points: usize,
    pub(crate) done: BTreeSet<usize>,
    pub(crate) points_done: usize,
    pub(crate) without_answer: usize,
    shards: BTreeSet<Shard>,
}

impl SweepProgress {
    /// The progress of one sweep in several directories.
    pub(crate) fn of(stores: &[Store]) -> Result<Self, QueryError> {
        let grid = &stores[0].plan.grid;
        let (chunks, points) = (grid.chunks(), grid.points());
        let mut progress = Self {
            chunks,
            points,
            done: BTreeSet::new(),
            points_done: 0,
            without_answer: 0,
            shards: BTreeSet::new(),
        };
        for store in stores {
            progress.shards.extend(store.shards()?);
            for chunk in 0..chunks {
                if progress.done.contains(&chunk) {
                    continue;
                }
                if let Some(rows) = store.rows(chunk)? {
                    progress.done.insert(chunk);
                    progress.points_done += grid.points_of(chunk).len();
                    // Without an answer there is a message behind the last comma.
                    progress.without_answer += rows.lines().filter(|row| !row.ends_with(",0,")).count();
                }
            }
        }
        Ok(progress)
    }

    /// The missing parts in words: the shards, if all belong to one division, or the number of chunks.
    pub(crate) fn missing(&self) -> Option<String> {
        let missing: Vec<usize> = (0..self.chunks).filter(|chunk| !self.done.contains(chunk)).collect();
        let first = missing.first()?;
        let of = self.shards.first().map(|shard| shard.of);
        let Some(of) = of.filter(|of| *of > 1 && self.shards.iter().all(|shard| shard.of == *of)) else {
            return Some(format!(
                "{} of {} chunks are missing, the first is chunk {first}",
                missing.len(),
                self.chunks
            ));
        };
        let lacking = |number| {
            let shard = Shard { of, number };
            let all = shard.chunks(self.chunks).count();
            let lacking = shard.chunks(self.chunks).filter(|chunk| !self.done.contains(chunk)).count();
            (lacking > 0).then(|| match lacking == all {
                true => shard.to_string(),
                false => format!("{lacking} of {all} chunks of {shard}"),
            })
        };
        let lacking: Vec<String> = (1..=of).filter_map(lacking).collect();
        Some(format!("missing are the shards {}", lacking.join(", ")))
    }
}
