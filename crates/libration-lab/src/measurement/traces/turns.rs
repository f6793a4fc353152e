//! Angles that jump by a turn, as encoders and arctangents give them.

use std::f64::consts::{PI, TAU};

use super::super::choices::Finding;

/// Removes jumps by whole turns, and whole turns of the angle at rest.
pub fn unwrap(angles: &mut [f64], name: &str, tell: &mut impl FnMut(Finding)) {
    let run = if name.is_empty() { String::new() } else { format!("{name}: ") };
    let jumps = take_out_jumps(angles);
    if jumps > 0 {
        tell(Finding::fact(format!("{run}{jumps} jumps by a turn taken out")));
    }
    let mut sorted = angles.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let turns = (sorted[sorted.len() / 2] / TAU).round();
    if turns != 0.0 {
        angles.iter_mut().for_each(|angle| *angle -= turns * TAU);
        let (count, word) = (turns.abs(), if turns.abs() > 1.0 { "turns" } else { "turn" });
        let how = if turns > 0.0 { "taken off" } else { "added" };
        tell(Finding::fact(format!(
            "{run}{count} whole {word} {how}, so that the angle of rest is near zero"
        )));
    }
}

/// Largest range of angles within one turn, with an allowance for noise and rounding at its ends.
const A_TURN: f64 = 1.02 * TAU;

/// Removes jumps if all angles are within one turn. A step is a jump if without whole turns it is below a quarter, or agrees with the steps before
/// and after it to a quarter, as that of a fast pendulum does.
pub fn take_out_jumps(angles: &mut [f64]) -> usize {
    let low = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let high = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if high - low > A_TURN {
        return 0;
    }
    let steps: Vec<f64> = angles.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (mut turns, mut jumps, mut before) = (0.0, 0, 0.0);
    for (row, &step) in steps.iter().enumerate() {
        let neighbours = [row.checked_sub(1).and_then(|row| steps.get(row)), steps.get(row + 1)];
        let whole = jump(before, step, neighbours);
        turns -= whole;
        jumps += usize::from(whole != 0.0);
        before = step - whole * TAU;
        angles[row + 1] += turns * TAU;
    }
    jumps
}

const QUARTER: f64 = PI / 2.0;

/// The whole turns in a step, given the corrected step before it and the uncorrected neighbouring steps.
fn jump(before: f64, step: f64, neighbours: [Option<&f64>; 2]) -> f64 {
    let nearest = (step / TAU).round();
    if nearest == 0.0 {
        return 0.0;
    }
    if is_nearly_whole(step) {
        // There and back by a step that is not a jump.
        let is_spike = |other: &f64| (step + other).abs() < QUARTER && !is_nearly_whole(*other);
        return if neighbours.into_iter().flatten().any(is_spike) { 0.0 } else { nearest };
    }
    let whole = ((step - before) / TAU).round();
    let remainder = step - whole * TAU;
    let goes_on =
        |after: &f64| (after - remainder - TAU * ((after - remainder) / TAU).round()).abs() < QUARTER;
    if (remainder - before).abs() < QUARTER && neighbours[1].is_some_and(goes_on) { whole } else { 0.0 }
}

fn is_nearly_whole(step: f64) -> bool {
    (step - (step / TAU).round() * TAU).abs() < QUARTER
}
