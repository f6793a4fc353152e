//! The least and the greatest value of a component of the state on a motion.

use crate::taylor::OwnedStep;
use libration_numbers::roots::{Tolerance, bisect};

/// The least and the greatest value.
pub type Extrema = [f64; 2];

/// The least and the greatest value of a component on some steps, less an even drift: at the ends of the steps, and where its rate of change goes
/// through zero within them, to the last digits.
pub fn extrema(steps: &[OwnedStep], component: usize, drift: f64, end: f64) -> Extrema {
    /// A step may be longer than from one turning point to the next: of an oscillator, whose series converge everywhere, it is 3 to 5 radians. None
    /// of its quarters has two of them.
    const PARTS: u32 = 4;
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut widen = |x: f64| range = [range[0].min(x), range[1].max(x)];
    for own in steps {
        let step = own.step();
        let (begin, length) = (step.start(), step.end().min(end) - step.start());
        let value = |time: f64| step.number_at(component, time) - drift * time;
        let rises = |time: f64| step.rate_at(component, time) > drift;
        let mut before = (begin, rises(begin));
        widen(value(begin));
        for number in 1..=PARTS {
            let time = begin + length * f64::from(number) / f64::from(PARTS);
            let after = (time, rises(time));
            if after.1 != before.1 {
                // A root of the error here is the error of the value.
                let is_before = |time: f64| rises(time) != after.1;
                let [turn, _] = bisect([before.0, time], Tolerance::relative(1e-9), is_before);
                widen(value(turn));
            }
            before = after;
        }
        widen(value(before.0));
    }
    range
}
