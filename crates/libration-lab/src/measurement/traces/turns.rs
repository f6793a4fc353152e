//! Angles that jump by a turn, as encoders and arctangents give them.

use std::f64::consts::{PI, TAU};

use super::super::choices::Finding;

/// Takes out jumps by whole turns, and whole turns of the angle of rest.
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

/// Only where all angles lie within one turn; a step that is no whole turn to within a quarter is no jump of the scale.
pub fn take_out_jumps(angles: &mut [f64]) -> usize {
    let low = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let high = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if high - low > TAU * (1.0 + 1e-9) {
        return 0;
    }
    let (mut turns, mut jumps, mut before) = (0.0, 0, angles[0]);
    for angle in angles.iter_mut() {
        let step = *angle - before;
        before = *angle;
        let whole = (step / TAU).round();
        if whole != 0.0 && (step - whole * TAU).abs() < PI / 2.0 {
            turns -= whole;
            jumps += 1;
        }
        *angle += turns * TAU;
    }
    jumps
}
