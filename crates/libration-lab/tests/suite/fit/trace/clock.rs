//! The uncertainty that a clock leaves: times that are all too long make ω0 too small.

use libration_lab::internals::fit::trace::clock::deviation;
use libration_lab::measurement::{Observable, Trace};

#[test]
fn clocks_are_wrong_together() {
    let trace = |clock: f64| {
        let trace = Trace::new("clock", Observable::Angle, vec![0.0, 1.0], vec![0.1, 0.2], None).unwrap();
        trace.with_clock_uncertainty(clock)
    };
    assert_eq!(deviation(&[trace(0.0)], 4.0).to_bits(), 0.0_f64.to_bits());
    assert!((deviation(&[trace(1e-3), trace(1e-3)], 4.0) - 4e-3).abs() < 1e-17);
    assert!((deviation(&[trace(1e-3), trace(0.0)], 4.0) - 2e-3).abs() < 1e-17);
}
