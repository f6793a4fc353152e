//! Work on other threads: independent pieces on all cores, and a line of progress beside long work.

use crate::interrupt;
use crate::output::progress::ProgressLine;
use libration::watch::Watch;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{available_parallelism, scope};
use std::time::Duration;

/// Between two looks at work that goes on.
const PAUSE: Duration = Duration::from_millis(50);

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

/// The results for the items, in their order, but for those that are not done when somebody asks for an early end; meanwhile a
/// line of progress counts `what`. Work asks its watch whether it may go on.
pub(crate) fn map_until_asked<T: Sync, R: Send>(
    items: &[T],
    what: &str,
    work: impl Fn(&T, &Watch<'_>) -> R + Sync,
) -> Vec<R> {
    let (all, done) = (items.len(), AtomicUsize::new(0));
    let counted = |item: &T| {
        let result = unless_asked(|watch| work(item, watch));
        done.fetch_add(usize::from(result.is_some()), Ordering::Relaxed);
        result
    };
    let how_far = || format!("{} of {all} {what}", done.load(Ordering::Relaxed));
    with_progress(how_far, || map(items, counted)).into_iter().flatten().collect()
}

/// The result of some work; `None` when somebody asks for an early end before.
pub(crate) fn until_asked<R: Send>(what: &str, work: impl FnOnce(&Watch<'_>) -> R + Send) -> Option<R> {
    with_progress(|| what.to_owned(), || unless_asked(work))
}

fn unless_asked<R>(work: impl FnOnce(&Watch<'_>) -> R) -> Option<R> {
    let watch = Watch::new(&|_| interrupt::go_on());
    watch.go_on().ok()?;
    let result = work(&watch);
    (!watch.is_stopped()).then_some(result)
}

/// Hands the result of each item on with its place.
fn for_each<T: Sync, R>(items: &[T], work: impl Fn(&T) -> R + Sync, done: &(impl Fn(usize, R) + Sync)) {
    let cores = available_parallelism().map_or(1, usize::from).min(items.len());
    let next = AtomicUsize::new(0);
    scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some((place, item)) = take(items, &next) {
                    done(place, work(item));
                }
            });
        }
    });
}

fn take<'a, T>(items: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    items.get(place).map(|item| (place, item))
}

/// Does some work on a thread of its own while a line of progress is shown.
pub(crate) fn with_progress<R: Send>(how_far: impl Fn() -> String, work: impl FnOnce() -> R + Send) -> R {
    let mut progress = ProgressLine::new();
    scope(|scope| {
        let worker = scope.spawn(work);
        while !worker.is_finished() {
            std::thread::park_timeout(PAUSE);
            progress.show(&how_far);
        }
        worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
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
    fn work_that_panics_panics() {
        let work = || until_asked("a panic", |_| assert!(std::hint::black_box(false)));
        assert!(std::panic::catch_unwind(work).is_err());
    }
}
