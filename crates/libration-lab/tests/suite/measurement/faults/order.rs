//! Times that repeat, go backwards, or begin again.

use libration_lab::internals::measurement::faults::order::restarts;

#[test]
fn three_rows_after_a_fall_begin_anew_and_two_do_not() {
    assert_eq!(restarts(&[1.0, 2.0, 3.0, 0.0, 0.5, 1.0]), [3]);
    assert_eq!(restarts(&[1.0, 2.0, 3.0, 0.0, 0.5]), []);
    // Times that stand still are not a fall back; one row that lies before all others is not a restart.
    assert_eq!(restarts(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.5]), [3]);
    assert_eq!(restarts(&[1.0, 2.0, 3.0, 0.0, 3.0, 4.0]), []);
    assert_eq!(restarts(&[2.0, 0.0, 1.0, 1.5]), [1]);
}
