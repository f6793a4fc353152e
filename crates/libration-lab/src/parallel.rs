//! Independent pieces of work on all cores.

use libration::internals::InOrder;
use libration::internals::progress::Watch;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, mpsc};
use std::thread::{available_parallelism, scope};

/// The results for all items, in their order, independent of the number of cores; the caller is consulted by
/// this thread, as often as on a single core.
pub fn map<T: Sync, R: Send>(
    items: &[T],
    watch: &Watch<'_>,
    work: impl Fn(&T, &Watch<'_>) -> R + Sync,
) -> Vec<R> {
    // Where there are no threads there is one core.
    let cores = available_parallelism().map_or(1, usize::from).min(items.len());
    if cores <= 1 {
        items.iter().map(|item| work(item, watch)).collect()
    } else {
        on_cores(cores, items, watch, work)
    }
}

/// The results of work on all items, in their order, by a number of threads.
pub fn on_cores<T: Sync, R: Send>(
    cores: usize,
    items: &[T],
    watch: &Watch<'_>,
    work: impl Fn(&T, &Watch<'_>) -> R + Sync,
) -> Vec<R> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::with_capacity(items.len())));
    // Questions, each with where its answer goes.
    let (questions, asked) = mpsc::channel::<mpsc::Sender<bool>>();
    scope(|scope| {
        for _ in 0..cores {
            let (questions, next, done, work) = (questions.clone(), &next, &done, &work);
            scope.spawn(move || {
                let (to_me, answers) = mpsc::channel();
                let ask = |_| match questions.send(to_me.clone()).is_ok() && answers.recv() == Ok(true) {
                    true => ControlFlow::Continue(()),
                    false => ControlFlow::Break(()),
                };
                let watch = Watch::new(&ask);
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(index) else { break };
                    let result = work(item, &watch);
                    done.lock().expect("no piece of work panics").push((index, result));
                }
            });
        }
        drop(questions);
        for answer in asked {
            // A receiver that no longer waits needs nothing.
            let _ = answer.send(watch.go_on().is_ok());
        }
    });
    let mut done = done.into_inner().expect("no piece of work panics");
    done.put_in_order_by(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}
