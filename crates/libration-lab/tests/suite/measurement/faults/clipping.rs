//! Values that stay constant while the motion goes on: stuck, or clipped at the ends of the scale.

use libration_lab::internals::measurement::faults::clipping::clipped;

/// Values that rise to a top of a number of rows and fall again, in steps of 0.1, and low values elsewhere.
fn top(rows: usize, beside: f64) -> Vec<f64> {
    [vec![-1.0, 0.0, 0.1, 1.0 - beside], vec![1.0; rows], vec![1.0 - beside, 0.1, 0.0, -0.9]].concat()
}

#[test]
fn three_rows_at_an_end_that_the_motion_leaves_fast_are_clipped_and_two_are_not() {
    let runs: Vec<(usize, usize)> = clipped(&top(3, 0.7)).iter().map(|run| (run.first, run.rows)).collect();
    assert_eq!(runs, [(4, 3)]);
    assert_eq!(clipped(&top(2, 0.7)), []);
    let upside_down: Vec<f64> = top(3, 0.7).iter().map(|value| -value).collect();
    assert!((clipped(&upside_down)[0].value + 1.0).abs() < 1e-15);
}

#[test]
fn a_turning_point_within_five_steps_of_the_scale_is_no_clipping() {
    assert_eq!(clipped(&top(3, 0.45)), []);
    assert_eq!(clipped(&top(3, 0.55)).len(), 1);
}
