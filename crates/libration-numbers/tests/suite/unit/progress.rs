use libration::internals::progress::Watch;
use libration::progress::{Interrupted, Progress, Quiet, Stage, Status};
use std::{cell::Cell, ops::ControlFlow};

#[test]
fn there_are_no_updates_after_a_cancellation() {
    let updates = Cell::new(0);
    let progress = |_: Status| {
        updates.set(updates.get() + 1);
        if updates.get() == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let watch = Watch::new(&progress);
    let outcomes: Vec<_> = (0..5).map(|done| watch.reached(done)).collect();
    assert_eq!(outcomes, [Ok(()), Ok(()), Err(Interrupted), Err(Interrupted), Err(Interrupted)]);
    assert_eq!(updates.get(), 3);
}

/// The last status that a call reports before it is cancelled.
fn reported(call: impl Fn(&Watch<'_>)) -> Option<Status> {
    let last = Cell::new(None);
    let progress = |status: Status| {
        last.set(Some(status));
        ControlFlow::Break(())
    };
    let watch = Watch::new(&progress);
    watch.begin(Stage::Whole, Some(7));
    call(&watch);
    assert!(watch.is_stopped());
    last.get()
}

#[test]
fn a_part_has_the_progress_of_the_whole() {
    let status = reported(|watch| {
        let part = watch.part();
        assert!(part.reached(1000).is_err() && part.is_stopped());
    });
    assert_eq!(status, Some(Status { stage: Stage::Whole, done: 0, of: Some(7) }));
}

#[test]
fn a_call_within_a_call_reports_its_own_progress() {
    let inner = Status { stage: Stage::Check, done: 2, of: Some(3) };
    assert_eq!(reported(|watch| assert!((watch as &dyn Progress).update(inner).is_break())), Some(inner));
}

#[test]
fn nothing_cancels_a_quiet_call() {
    let watch = Watch::new(&Quiet);
    assert!(watch.reached(1).is_ok() && watch.flow().is_continue() && !watch.is_stopped());
}
