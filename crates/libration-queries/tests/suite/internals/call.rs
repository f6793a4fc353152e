//! Threads and the questions they work for.

use libration_queries::internals::call::{Call, Nobody, current, within};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

#[test]
fn a_thread_goes_back_to_what_it_worked_for_before() {
    let call = || Call::new(vec![], Arc::new(Nobody));
    let (outer, inner) = (call(), call());
    within(&outer, || {
        within(&inner, || assert!(Arc::ptr_eq(&current(), &inner)));
        assert!(Arc::ptr_eq(&current(), &outer));
        let fails = || within(&inner, || assert!(std::hint::black_box(false)));
        assert!(catch_unwind(AssertUnwindSafe(fails)).is_err());
        assert!(Arc::ptr_eq(&current(), &outer));
    });
}
