//! Independent pieces of work on all cores.

use std::cell::Cell;
use std::ops::ControlFlow;

use libration::internals::progress::Watch;
use libration::progress::{Quiet, Status};
use libration_lab::internals::parallel::{map, on_cores};

#[test]
fn results_and_updates_do_not_depend_on_the_number_of_cores() {
    let items: Vec<usize> = (0..50).collect();
    for cores in 1..=4 {
        let updates = Cell::new(0);
        let progress = |_: Status| {
            updates.set(updates.get() + 1);
            ControlFlow::Continue(())
        };
        let squares = on_cores(cores, &items, &Watch::new(&progress), |item, watch| {
            assert!(watch.go_on().is_ok());
            item * item
        });
        assert_eq!(squares, items.iter().map(|n| n * n).collect::<Vec<_>>());
        assert_eq!(updates.get(), items.len());
    }
}

#[test]
fn a_cancellation_reaches_all_cores() {
    let items: Vec<usize> = (0..50).collect();
    let watch = Watch::new(&|_: Status| ControlFlow::Break(()));
    let stopped = on_cores(3, &items, &watch, |_, watch| watch.go_on().is_err());
    assert!(stopped.into_iter().all(|stopped| stopped) && watch.is_stopped());
    assert!(map(&[] as &[u8], &Watch::new(&Quiet), |_, _| 0).is_empty());
}
