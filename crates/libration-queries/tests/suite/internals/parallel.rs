//! Work on several threads.

use libration_queries::internals::parallel::{in_order, map, map_unless_cancelled, unless_cancelled};
use std::panic::catch_unwind;

#[test]
fn results_come_in_the_order_of_the_items() {
    let items: Vec<usize> = (0..1000).collect();
    let squares: Vec<usize> = items.iter().map(|n| n * n).collect();
    assert_eq!(map(&items, |item| item * item), squares);
    assert!(map(&[] as &[u8], |_| 0).is_empty());
    assert_eq!(map_unless_cancelled(&items, "squares", |item, _| item * item), squares);
    assert!(map_unless_cancelled(&[] as &[u8], "nothing", |_, _| 0).is_empty());
}

#[test]
fn results_are_handed_on_in_order_until_that_fails() {
    for places in [0, 1, 7, 1000] {
        let mut seen = vec![];
        let all = in_order(
            places,
            |index| index * index,
            |index, square| {
                seen.push((index, square));
                Ok::<(), ()>(())
            },
        );
        assert_eq!((all, seen), (Ok(()), (0..places).map(|index| (index, index * index)).collect()));
    }
    let mut seen = 0;
    let stopped = in_order(
        1000,
        |index| index,
        |index, _| {
            seen += 1;
            if index == 10 { Err("full") } else { Ok(()) }
        },
    );
    assert_eq!((stopped, seen), (Err("full"), 11));
}

#[test]
fn work_that_panics_panics() {
    let work = || unless_cancelled("a panic", |_| assert!(std::hint::black_box(false)));
    assert!(catch_unwind(work).is_err());
    let one = |index: usize| assert!(std::hint::black_box(index != 5));
    let in_order = || in_order(100, one, |_, ()| Ok::<(), ()>(()));
    assert!(catch_unwind(in_order).is_err());
}
