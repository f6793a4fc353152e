//! Independent pieces of work on all cores.

use std::cell::Cell;
use std::ops::ControlFlow;

use libration::watch::Watch;
use libration_lab::internals::parallel::{map, on_cores};

#[test]
fn results_and_questions_do_not_depend_on_the_number_of_cores() {
    let items: Vec<usize> = (0..50).collect();
    for cores in 1..=4 {
        let asked = Cell::new(0);
        let ask = |_| {
            asked.set(asked.get() + 1);
            ControlFlow::Continue(())
        };
        let squares = on_cores(cores, &items, &Watch::new(&ask), |item, watch| {
            assert!(watch.go_on().is_ok());
            item * item
        });
        assert_eq!(squares, items.iter().map(|n| n * n).collect::<Vec<_>>());
        assert_eq!(asked.get(), items.len());
    }
}

#[test]
fn all_are_told_to_stop() {
    let items: Vec<usize> = (0..50).collect();
    let ask = |_| ControlFlow::Break(());
    let watch = Watch::new(&ask);
    let stopped = on_cores(3, &items, &watch, |_, watch| watch.go_on().is_err());
    assert!(stopped.into_iter().all(|stopped| stopped) && watch.is_stopped());
    assert!(map(&[] as &[u8], &Watch::none(), |_, _| 0).is_empty());
}
