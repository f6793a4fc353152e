//! Work on other threads: independent pieces on all cores, and a line of progress beside long work.

use crate::output::progress::ProgressLine;
use crate::{call, interrupt};
use libration::watch::Watch;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{available_parallelism, scope};
use std::time::Duration;

/// Between two looks at work that goes on.
const PAUSE: Duration = Duration::from_millis(50);

/// Without threads the thread that asks does everything itself, and shows progress where the work asks whether it may go on.
const HAS_THREADS: bool = cfg!(not(target_family = "wasm"));

/// The results for all items, in their order. Which core did which, and how many there are, changes nothing.
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let done = Mutex::new(Vec::with_capacity(items.len()));
    for_each(items, work, &|place, result| {
        done.lock().expect("no piece of work panics").push((place, result));
    });
    let mut done = done.into_inner().expect("no piece of work panics");
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Hands the results for so many places on in their order, while the next ones are made on all cores; until it fails, or somebody asks
/// for an early end. No core is more than a few places ahead.
pub(crate) fn in_order<R: Send, E>(
    places: usize,
    work: impl Fn(usize) -> R + Sync,
    mut hand_on: impl FnMut(usize, R) -> Result<(), E>,
) -> Result<(), E> {
    if !HAS_THREADS {
        return (0..places)
            .take_while(|_| !interrupt::asked())
            .try_for_each(|place| hand_on(place, work(place)));
    }
    let cores = available_parallelism().map_or(1, usize::from);
    let (orders, to_do) = channel();
    let (finished, results) = channel();
    let to_do = Mutex::new(to_do);
    let call = call::current();
    scope(|scope| {
        // Dropped with what is left to be done when no more is wanted.
        let (orders, results) = (orders, results);
        for _ in 0..cores {
            let (finished, to_do, work, call) = (finished.clone(), &to_do, &work, &call);
            scope.spawn(move || {
                while let Some(place) = next_order(to_do) {
                    let result = catch_unwind(AssertUnwindSafe(|| call::within(call, || work(place))));
                    if finished.send((place, result)).is_err() {
                        break;
                    }
                }
            });
        }
        let mut ordered = 0..places;
        let mut ahead = BTreeMap::new();
        for place in 0..places {
            for order in ordered.by_ref().take(if place == 0 { AHEAD * cores } else { 1 }) {
                orders.send(order).expect("the cores wait for orders");
            }
            if interrupt::asked() {
                break;
            }
            while !ahead.contains_key(&place) {
                let (place, result) = results.recv().expect("what is ordered is finished");
                ahead.insert(place, result.unwrap_or_else(|panic| resume_unwind(panic)));
            }
            ahead.remove(&place).map_or(Ok(()), |result| hand_on(place, result))?;
        }
        Ok(())
    })
}

/// How many places each core has before it.
const AHEAD: usize = 4;

fn next_order(to_do: &Mutex<Receiver<usize>>) -> Option<usize> {
    to_do.lock().ok()?.recv().ok()
}

/// The results for the items, in their order, but for those that are not done when somebody asks for an early end; meanwhile a
/// line of progress counts `what`. Work asks its watch whether it may go on.
pub(crate) fn map_until_asked<T: Sync, R: Send>(
    items: &[T],
    what: &str,
    work: impl Fn(&T, &Watch<'_>) -> R + Sync,
) -> Vec<R> {
    let (all, done) = (items.len(), AtomicUsize::new(0));
    let how_far = || format!("{} of {all} {what}", done.load(Ordering::Relaxed));
    let counted = |item: &T| {
        let result = unless_asked(&how_far, |watch| work(item, watch));
        done.fetch_add(usize::from(result.is_some()), Ordering::Relaxed);
        result
    };
    with_progress(how_far, || map(items, counted)).into_iter().flatten().collect()
}

/// The result of some work; `None` when somebody asks for an early end before.
pub(crate) fn until_asked<R: Send>(what: &str, work: impl FnOnce(&Watch<'_>) -> R + Send) -> Option<R> {
    let how_far = || what.to_owned();
    with_progress(how_far, || unless_asked(&how_far, work))
}

fn unless_asked<R>(how_far: &dyn Fn() -> String, work: impl FnOnce(&Watch<'_>) -> R) -> Option<R> {
    let ask = |_| go_on(how_far);
    let watch = Watch::new(&ask);
    watch.go_on().ok()?;
    let result = work(&watch);
    (!watch.is_stopped()).then_some(result)
}

/// Hands the result of each item on with its place.
fn for_each<T: Sync, R>(items: &[T], work: impl Fn(&T) -> R + Sync, done: &(impl Fn(usize, R) + Sync)) {
    let cores = available_parallelism().map_or(1, usize::from).min(items.len());
    let (next, call) = (AtomicUsize::new(0), call::current());
    let until_done = || {
        while let Some((place, item)) = take(items, &next) {
            done(place, work(item));
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

fn take<'a, T>(items: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    items.get(place).map(|item| (place, item))
}

thread_local! {
    /// The line of the work that the only thread does.
    static ALONE: RefCell<Option<ProgressLine>> = const { RefCell::new(None) };
}

/// Whether work may go on that is so far. Where no other thread shows a line of progress, it is shown here.
pub(crate) fn go_on(how_far: &dyn Fn() -> String) -> ControlFlow<()> {
    if !HAS_THREADS {
        ALONE.with_borrow_mut(|line| line.iter_mut().for_each(|line| line.show(how_far)));
    }
    interrupt::go_on()
}

/// Does some work on a thread of its own while a line of progress is shown.
pub(crate) fn with_progress<R: Send>(how_far: impl Fn() -> String, work: impl FnOnce() -> R + Send) -> R {
    if !HAS_THREADS {
        let outer = ALONE.replace(Some(ProgressLine::new()));
        let result = work();
        ALONE.set(outer);
        return result;
    }
    let mut progress = ProgressLine::new();
    let call = call::current();
    let (working, end) = channel::<()>();
    scope(|scope| {
        let worker = scope.spawn(|| {
            // Hangs up when the work has ended.
            let _working = working;
            call::within(&call, work)
        });
        while end.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
            // Some hosts hear of Ctrl-C on this thread alone.
            let _ = interrupt::asked();
            progress.show(&how_far);
        }
        worker.join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..1000).collect();
        let squares: Vec<usize> = items.iter().map(|n| n * n).collect();
        assert_eq!(map(&items, |item| item * item), squares);
        assert!(map(&[] as &[u8], |_| 0).is_empty());
        assert_eq!(map_until_asked(&items, "squares", |item, _| item * item), squares);
        assert!(map_until_asked(&[] as &[u8], "nothing", |_, _| 0).is_empty());
    }

    #[test]
    fn results_are_handed_on_in_order_until_that_fails() {
        for places in [0, 1, 7, 1000] {
            let mut seen = vec![];
            let all = in_order(
                places,
                |place| place * place,
                |place, square| {
                    seen.push((place, square));
                    Ok::<(), ()>(())
                },
            );
            assert_eq!((all, seen), (Ok(()), (0..places).map(|place| (place, place * place)).collect()));
        }
        let mut seen = 0;
        let stopped = in_order(
            1000,
            |place| place,
            |place, _| {
                seen += 1;
                if place == 10 { Err("full") } else { Ok(()) }
            },
        );
        assert_eq!((stopped, seen), (Err("full"), 11));
    }

    #[test]
    fn work_that_panics_panics() {
        let work = || until_asked("a panic", |_| assert!(std::hint::black_box(false)));
        assert!(catch_unwind(work).is_err());
        let one = |place: usize| assert!(std::hint::black_box(place != 5));
        let in_order = || in_order(100, one, |_, ()| Ok::<(), ()>(()));
        assert!(catch_unwind(in_order).is_err());
    }
}
