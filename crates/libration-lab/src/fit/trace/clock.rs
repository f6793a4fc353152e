//! What the clock leaves open: times that are all too long by one part in a thousand make ω0 too small by as much.

use super::Parameter;
use crate::measurement::Trace;

/// Normal deviates of the intervals' levels, 68.3 % and 95 %.
const DEVIATES: [f64; 2] = [1.0, 1.96];

/// Adds what the clocks of the traces are uncertain by to the uncertainty of ω0 and its intervals. The rates of damping are not
/// known well enough to notice.
pub(super) fn add(traces: &[Trace], omega0: &mut Parameter) {
    // One clock may have timed all traces: their mean is not better known than each.
    let clocks: f64 = traces.iter().map(Trace::clock_uncertainty).sum();
    let by_clock = omega0.value * clocks / super::count(traces.len());
    omega0.uncertainty = libm::hypot(omega0.uncertainty, by_clock);
    for (interval, deviate) in omega0.intervals.iter_mut().zip(DEVIATES) {
        for (end, side) in interval.iter_mut().zip([-1.0_f64, 1.0]) {
            *end = side.mul_add(libm::hypot(*end - omega0.value, deviate * by_clock), omega0.value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::Seen;

    #[test]
    fn an_uncertain_clock_makes_the_frequency_uncertain() {
        let trace = Trace::new("clock", Seen::Angle, vec![0.0, 1.0], vec![0.1, 0.2], None).unwrap();
        let fitted = Parameter {
            value: 4.0,
            uncertainty: 3e-3,
            intervals: [[3.997, 4.003], [3.994, 4.006]],
            ..Parameter::default()
        };
        let mut sure = fitted.clone();
        add(std::slice::from_ref(&trace), &mut sure);
        assert!((sure.uncertainty - 3e-3).abs() < 1e-15 && (sure.intervals[0][1] - 4.003).abs() < 1e-15);
        let mut unsure = fitted;
        add(&[trace.with_clock_uncertainty(1e-3)], &mut unsure);
        assert!((unsure.uncertainty - 5e-3).abs() < 1e-15, "3, 4, 5: {unsure:?}");
        let [[low, high], [_, highest]] = unsure.intervals;
        assert!((low - 3.995).abs() < 1e-12 && (high - 4.005).abs() < 1e-12);
        assert!((highest - 4.0 - libm::hypot(6e-3, 1.96 * 4e-3)).abs() < 1e-12);
    }
}
