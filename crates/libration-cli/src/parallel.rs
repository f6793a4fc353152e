//! Independent pieces of work on all cores.

use crate::interrupt;
use crate::output::progress::Progress;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{available_parallelism, scope};
use std::time::Duration;

/// The results for all items, in their order. Which core did which, and how many there are, changes nothing.
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let cores = available_parallelism().map_or(1, usize::from).min(items.len());
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, R)>> = Mutex::new(Vec::with_capacity(items.len()));
    scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some((place, item)) = take(items, &next) {
                    let result = work(item);
                    done.lock().expect("no piece of work panics").push((place, result));
                }
            });
        }
    });
    let mut done = done.into_inner().expect("no piece of work panics");
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}

/// The results for the items, in their order, as far as they are done when somebody asks for an early end; meanwhile
/// a line of progress counts `what`.
pub(crate) fn map_until_asked<T: Sync, R: Send>(
    items: &[T],
    what: &str,
    work: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let done = AtomicUsize::new(0);
    let counted = |item: &T| {
        let result = (!interrupt::asked()).then(|| work(item));
        done.fetch_add(1, Ordering::Relaxed);
        result
    };
    let how_far = || format!("{} of {} {what}", done.load(Ordering::Relaxed), items.len());
    with_progress(how_far, || map(items, counted)).into_iter().map_while(|result| result).collect()
}

fn take<'a, T>(items: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    items.get(place).map(|item| (place, item))
}

/// Does some work on a thread of its own while a line of progress is shown.
pub(crate) fn with_progress<R: Send>(how_far: impl Fn() -> String, work: impl FnOnce() -> R + Send) -> R {
    const PAUSE: Duration = Duration::from_millis(50);
    let mut progress = Progress::new();
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
        assert_eq!(map(&items, |item| item * item), items.iter().map(|n| n * n).collect::<Vec<_>>());
        assert!(map(&[] as &[u8], |_| 0).is_empty());
    }
}
