//! Uncertainty by the clock: times that are all too long by one part in a thousand make ω0 too small by as much.

use crate::measurement::Trace;
use crate::statistics::count;

/// One standard deviation of ω0 by the clocks of the traces. The rates of damping are not known well enough to notice.
pub fn deviation(traces: &[Trace], omega0: f64) -> f64 {
    // One clock may have timed all traces: their mean is not better known than each.
    let clocks: f64 = traces.iter().map(Trace::clock_uncertainty).sum();
    omega0 * clocks / count(traces.len())
}
