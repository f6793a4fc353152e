//! The least and the greatest value of a component of the state on a motion.

use crate::taylor::OwnedStep;
use libration_numbers::roots::{Tolerance, bisect};

/// The least and the greatest value.
pub type Extrema = [f64; 2];

/// The least and the greatest value of a component on some steps, minus a constant drift: at the
/// ends of the steps, and at the zeros of its rate of change within them, to the last digits.
pub fn extrema(steps: &[OwnedStep], component: usize, drift: f64, end: f64) -> Extrema {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut widen = |x: f64| range = [range[0].min(x), range[1].max(x)];
    for owned in steps {
        let step = owned.step();
        let turns = turns_in(owned, component, drift, end);
        for time in [step.start(), step.end().min(end)].into_iter().chain(turns) {
            widen(step.number_at(component, time) - drift * time);
        }
    }
    range
}

/// The times within a step at which the rate of change of a component equals a drift.
pub fn turns_in(owned: &OwnedStep, component: usize, drift: f64, end: f64) -> Vec<f64> {
    /// Number of parts of a step that are searched. A step may be longer than the time between turning points: for an oscillator, whose series
    /// converge everywhere, it is 3 to 5 radians. None of its quarters contains two turning points.
    const PARTS: u32 = 4;
    let step = owned.step();
    let (begin, length) = (step.start(), step.end().min(end) - step.start());
    let rises = |time: f64| step.rate_at(component, time) > drift;
    let time = |number: u32| begin + length * f64::from(number) / f64::from(PARTS);
    let rising: Vec<bool> = (0..=PARTS).map(|number| rises(time(number))).collect();
    let turns = (0..PARTS).zip(rising.windows(2)).filter(|(_, pair)| pair[0] != pair[1]);
    let turn = |(number, pair): (u32, &[bool])| {
        // An error of the zero found here would be an error of the value.
        let ends = [time(number), time(number + 1)];
        bisect(ends, Tolerance::relative(1e-9), |time| rises(time) != pair[1])[0]
    };
    turns.map(turn).collect()
}
