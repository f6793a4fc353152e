use libration::watch::{Interrupted, Progress, Stage, Watch};
use std::{cell::Cell, ops::ControlFlow};

#[test]
fn whoever_has_said_stop_is_asked_no_more() {
    let asked = Cell::new(0);
    let ask = |_| {
        asked.set(asked.get() + 1);
        if asked.get() == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let watch = Watch::new(&ask);
    let answers: Vec<_> = (0..5).map(|done| watch.reached(done)).collect();
    assert_eq!(answers, [Ok(()), Ok(()), Err(Interrupted), Err(Interrupted), Err(Interrupted)]);
    assert_eq!(asked.get(), 3);
}

#[test]
fn a_part_asks_with_the_progress_of_the_whole() {
    let last = Cell::new(None);
    let ask = |progress: Progress| {
        last.set(Some(progress));
        ControlFlow::Break(())
    };
    let watch = Watch::new(&ask);
    watch.begin(Stage::Whole, Some(7));
    let part = watch.part();
    assert!(part.reached(1000).is_err() && part.is_stopped() && watch.is_stopped());
    assert_eq!(last.get(), Some(Progress { stage: Stage::Whole, done: 0, of: Some(7) }));
}

#[test]
fn nobody_stops_what_is_not_watched() {
    let watch = Watch::none();
    assert!(watch.reached(1).is_ok() && watch.flow().is_continue() && !watch.is_stopped());
}
