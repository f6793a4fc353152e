//! Curves end at the edge of the frame.

use libration_report::chart::{Axis, Panel, Series};
use libration_report::internals::clip::visible_pieces;
use libration_report::scene::Place;
use libration_report::style;

fn pieces(points: &[Place]) -> Vec<Vec<Place>> {
    let x = Axis::linear("", 0.0, 10.0);
    let y = Axis::logarithmic("", 0.01, 1.0);
    let panel = Panel { x, y, series: vec![], share: 1.0 };
    visible_pieces(&Series::line("", style::curve(0), points.to_vec()), &panel)
}

#[test]
fn a_curve_that_leaves_the_frame_ends_at_its_edge() {
    assert_eq!(pieces(&[(0.0, 0.1), (2.0, 0.001)]), [[(0.0, 0.5), (0.1, 0.0)]]);
}

#[test]
fn a_curve_that_comes_back_is_drawn_in_pieces() {
    assert_eq!(pieces(&[(0.0, 0.1), (2.0, 0.001), (4.0, 0.1)]).len(), 2);
}

#[test]
fn what_is_not_a_number_is_a_gap() {
    assert_eq!(pieces(&[(0.0, 0.1), (1.0, 0.1), (2.0, f64::NAN), (3.0, 0.1), (4.0, 0.1)]).len(), 2);
}
