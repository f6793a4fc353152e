//! Parallel work: independent pieces on all cores, with a progress line during long work.

use crate::output::progress::ProgressLine;
use crate::{call, interrupt};
use libration::internals::progress::Watch;
use libration::progress::{Progress, Status};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard};
use std::thread::{available_parallelism, scope};
use std::time::Duration;

/// Interval between two checks of running work.
const PAUSE: Duration = Duration::from_millis(50);

/// `false` where the calling thread does all work itself, and shows progress where the work checks for cancellation.
const HAS_THREADS: bool = cfg!(not(target_family = "wasm"));

/// The results for all items, in their order; they do not depend on the number of cores.
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let done = Mutex::new(Vec::with_capacity(items.len()));
    locked(&done).resize_with(items.len(), || None);
    on_all_cores(items.len(), &|index| {
        let result = work(&items[index]);
        locked(&done)[index] = Some(result);
    });
    let done = done.into_inner().expect("no piece of work panics");
    done.into_iter().map(|result| result.expect("every piece is done")).collect()
}

/// The results so far; pieces of work panic outside their lock.
fn locked<R>(done: &Mutex<R>) -> MutexGuard<'_, R> {
    done.lock().expect("no piece of work panics")
}

/// Passes on the results for `count` indices in their order, while the next ones are computed on all cores, until passing one on fails or the run
/// is cancelled. Cores are at most a few indices ahead.
pub fn in_order<R: Send, E>(
    count: usize,
    work: impl Fn(usize) -> R + Sync,
    mut hand_on: impl FnMut(usize, R) -> Result<(), E>,
) -> Result<(), E> {
    let (made, mut failure) = (Mutex::new(Vec::new()), None);
    make_in_order(
        count,
        &|index| {
            let result = work(index);
            locked(&made).push((index, result));
        },
        &mut |index| {
            let mut made = locked(&made);
            let position = made.iter().position(|(made, _)| *made == index).expect("the index is made");
            let (_, result) = made.swap_remove(position);
            drop(made);
            failure = hand_on(index, result).err();
            failure.is_none()
        },
    );
    failure.map_or(Ok(()), Err)
}

/// Computes `count` indices on all cores and reports each in its order, until `hand_on` returns `false` or the run is cancelled.
fn make_in_order(count: usize, make: &(dyn Fn(usize) + Sync), hand_on: &mut dyn FnMut(usize) -> bool) {
    if !HAS_THREADS {
        for index in 0..count {
            if interrupt::is_cancelled() {
                break;
            }
            make(index);
            if !hand_on(index) {
                break;
            }
        }
        return;
    }
    let cores = available_parallelism().map_or(1, usize::from);
    let (orders, to_do) = channel();
    let (finished, made) = channel();
    let to_do = Mutex::new(to_do);
    let call = call::current();
    scope(|scope| {
        // Dropped with what is left to be done when no more is wanted.
        let (orders, made) = (orders, made);
        for _ in 0..cores {
            let (finished, to_do, call) = (finished.clone(), &to_do, &call);
            scope.spawn(move || {
                while let Some(index) = next_order(to_do) {
                    let result = catch_unwind(AssertUnwindSafe(|| call::within(call, || make(index))));
                    if finished.send((index, result)).is_err() {
                        break;
                    }
                }
            });
        }
        let mut ordered = 0..count;
        let mut ahead = BTreeSet::new();
        for index in 0..count {
            for order in ordered.by_ref().take(if index == 0 { AHEAD * cores } else { 1 }) {
                orders.send(order).expect("the cores wait for orders");
            }
            if interrupt::is_cancelled() {
                break;
            }
            while !ahead.contains(&index) {
                let (ready, result) = made.recv().expect("what is ordered is finished");
                result.unwrap_or_else(|panic| resume_unwind(panic));
                ahead.insert(ready);
            }
            ahead.remove(&index);
            if !hand_on(index) {
                break;
            }
        }
    });
}

/// Number of indices that each core has before it.
const AHEAD: usize = 4;

fn next_order(to_do: &Mutex<Receiver<usize>>) -> Option<usize> {
    to_do.lock().ok()?.recv().ok()
}

/// The results for the items, in their order, except those not finished when the run is cancelled; a progress line counts `what` meanwhile.
pub fn map_unless_cancelled<T: Sync, R: Send>(
    items: &[T],
    what: &str,
    work: impl Fn(&T, &dyn Progress) -> R + Sync,
) -> Vec<R> {
    let (all, done) = (items.len(), AtomicUsize::new(0));
    let how_far = || format!("{} of {all} {what}", done.load(Ordering::Relaxed));
    let counted = |item: &T| {
        let result = unless_cancelled_at(&how_far, |progress| work(item, progress));
        done.fetch_add(usize::from(result.is_some()), Ordering::Relaxed);
        result
    };
    let mut results = Vec::with_capacity(all);
    for result in with_progress(how_far, || map(items, counted)) {
        results.extend(result);
    }
    results
}

/// The result of some work; `None` if the run is cancelled before its end.
pub fn unless_cancelled<R: Send>(what: &str, work: impl FnOnce(&dyn Progress) -> R + Send) -> Option<R> {
    let how_far = || what.to_owned();
    with_progress(how_far, || unless_cancelled_at(&how_far, work))
}

/// The result of some work, with the number of its checks for cancellation as progress: the number of steps, values or orders done, in `unit`.
pub(crate) fn unless_cancelled_counted<R: Send>(
    what: &str,
    unit: &str,
    work: impl FnOnce(&dyn Progress) -> R + Send,
) -> Option<R> {
    let updates = AtomicUsize::new(0);
    let how_far = || format!("{what}: {} {unit}", updates.load(Ordering::Relaxed));
    let progress = |_: Status| {
        updates.fetch_add(1, Ordering::Relaxed);
        update(&how_far)
    };
    with_progress(how_far, || unless_stopped(&progress, work))
}

fn unless_cancelled_at<R>(how_far: &dyn Fn() -> String, work: impl FnOnce(&dyn Progress) -> R) -> Option<R> {
    unless_stopped(&|_: Status| update(how_far), work)
}

fn unless_stopped<R>(progress: &dyn Progress, work: impl FnOnce(&dyn Progress) -> R) -> Option<R> {
    let watch = Watch::new(progress);
    watch.go_on().ok()?;
    let result = work(&watch);
    (!watch.is_stopped()).then_some(result)
}

/// Does `pieces` pieces of work on all cores.
fn on_all_cores(pieces: usize, work: &(dyn Fn(usize) + Sync)) {
    let cores = available_parallelism().map_or(1, usize::from).min(pieces);
    let (next, call) = (AtomicUsize::new(0), call::current());
    let until_done = || {
        while let Some(index) = take(pieces, &next) {
            work(index);
        }
    };
    if !HAS_THREADS {
        return until_done();
    }
    scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| call::within(&call, until_done));
        }
    });
}

fn take(pieces: usize, next: &AtomicUsize) -> Option<usize> {
    Some(next.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < pieces)
}

thread_local! {
    /// The line of the work that the only thread does.
    static ALONE: RefCell<Option<ProgressLine>> = const { RefCell::new(None) };
}

/// Updates the progress of a run; `Break` if the run is cancelled. The progress line is shown here if no other thread shows it.
pub(crate) fn update(how_far: &dyn Fn() -> String) -> ControlFlow<()> {
    if !HAS_THREADS {
        ALONE.with_borrow_mut(|line| line.iter_mut().for_each(|line| line.show(how_far)));
    }
    interrupt::check()
}

/// Does some work on its own thread while a progress line is shown.
pub(crate) fn with_progress<R: Send>(how_far: impl Fn() -> String, work: impl FnOnce() -> R + Send) -> R {
    let (mut work, mut result) = (Some(work), None);
    beside_progress(&how_far, &mut || result = work.take().map(|work| work()));
    result.expect("the work has ended")
}

/// Does the work once on its own thread.
fn beside_progress(how_far: &dyn Fn() -> String, work: &mut (dyn FnMut() + Send)) {
    if !HAS_THREADS {
        let outer = ALONE.replace(Some(ProgressLine::new()));
        work();
        ALONE.set(outer);
        return;
    }
    let mut progress = ProgressLine::new();
    let call = call::current();
    let (working, end) = channel::<()>();
    scope(|scope| {
        let worker = scope.spawn(|| {
            // Hangs up when the work has ended.
            let _working = working;
            call::within(&call, work);
        });
        while end.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
            // Some hosts hear of Ctrl-C on this thread alone.
            let _ = interrupt::is_cancelled();
            progress.show(how_far);
        }
        worker.join().unwrap_or_else(|panic| resume_unwind(panic));
    });
}
