//! Work on other threads: independent pieces on all cores, and long work that nobody has to wait for.

use crate::interrupt;
use crate::output::progress::Progress;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{available_parallelism, scope, spawn};
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

/// The results for the items, in their order, but for those that are not done when somebody asks for an early end, since no
/// piece of work that is under way then is waited for; meanwhile a line of progress counts `what`.
pub(crate) fn map_until_asked<T: Send + Sync + 'static, R: Send + 'static>(
    items: Vec<T>,
    what: &str,
    work: impl Fn(&T) -> R + Send + Sync + 'static,
) -> Vec<R> {
    let all = items.len();
    let mut done = sent_until_asked(
        |done| format!("{done} of {all} {what}"),
        move |sender| for_each(&items, work, &|place, result| send(sender, (place, result))),
    );
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
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

/// The result of some work; `None` when somebody asks for an early end before.
pub(crate) fn until_asked<R: Send + 'static>(
    what: &str,
    work: impl FnOnce() -> R + Send + 'static,
) -> Option<R> {
    sent_until_asked(|_| what.to_owned(), |sender| send(sender, work())).pop()
}

/// What some work sends until it ends, or until somebody asks for an early end; meanwhile a line of progress is made of the
/// number of results. In the second case the work is left alone, and ends with the process, so that nobody waits for what
/// takes long.
pub(crate) fn sent_until_asked<R: Send + 'static>(
    how_far: impl Fn(usize) -> String,
    work: impl FnOnce(&Sender<R>) + Send + 'static,
) -> Vec<R> {
    let mut sent = vec![];
    if interrupt::asked() {
        return sent;
    }
    let (sender, receiver) = channel();
    let worker = spawn(move || work(&sender));
    let mut progress = Progress::new();
    while receive(&receiver, &mut sent) {
        if interrupt::asked() {
            sent.extend(receiver.try_iter());
            return sent;
        }
        progress.show(|| how_far(sent.len()));
    }
    worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    sent
}

/// Takes what has come, or comes soon; `false` when nothing comes any more.
fn receive<R>(receiver: &Receiver<R>, sent: &mut Vec<R>) -> bool {
    match receiver.recv_timeout(PAUSE) {
        Ok(result) => sent.push(result),
        Err(RecvTimeoutError::Timeout) => {}
        Err(RecvTimeoutError::Disconnected) => return false,
    }
    true
}

/// Sends a result. Whoever has left does not want it.
pub(crate) fn send<R>(sender: &Sender<R>, result: R) {
    let _ = sender.send(result);
}

/// Does some work on a thread of its own while a line of progress is shown.
pub(crate) fn with_progress<R: Send>(how_far: impl Fn() -> String, work: impl FnOnce() -> R + Send) -> R {
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
        let squares: Vec<usize> = items.iter().map(|n| n * n).collect();
        assert_eq!(map(&items, |item| item * item), squares);
        assert!(map(&[] as &[u8], |_| 0).is_empty());
        assert_eq!(map_until_asked(items, "squares", |item| item * item), squares);
        assert!(map_until_asked(vec![], "nothing", |_: &u8| 0).is_empty());
    }

    #[test]
    fn work_that_panics_is_not_waited_for() {
        let work = || until_asked("a panic", || assert!(std::hint::black_box(false)));
        assert!(std::panic::catch_unwind(work).is_err());
    }
}
