//! What the clock leaves open: times that are all too long by one part in a thousand make ω0 too small by as much.

use crate::measurement::Trace;
use crate::statistics::count;

/// One standard deviation of ω0 by the clocks of the traces. The rates of damping are not known well enough to notice.
pub(super) fn deviation(traces: &[Trace], omega0: f64) -> f64 {
    // One clock may have timed all traces: their mean is not better known than each.
    let clocks: f64 = traces.iter().map(Trace::clock_uncertainty).sum();
    omega0 * clocks / count(traces.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::Observable;

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
}
