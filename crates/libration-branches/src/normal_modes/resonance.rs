//! Frequencies that are small multiples of each other.

use super::mode::{Behaviour, Mode, Resonance};
use libration_numbers::algebra::{Rational, Surd};

/// Largest detuning of a resonance.
const NEAR: f64 = 0.05;
/// Largest detuning that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// All resonances of a mode.
pub(super) fn resonances(modes: &[Mode], number: usize) -> Vec<Resonance> {
    let oscillates = |mode: &Mode| mode.behaviour == Behaviour::Oscillating;
    if !oscillates(&modes[number]) {
        return vec![];
    }
    let others = (0..modes.len()).filter(|&other| other != number && oscillates(&modes[other]));
    others
        .flat_map(|other| (1..=3).filter_map(move |multiple| between(modes, number, other, multiple)))
        .collect()
}

fn between(modes: &[Mode], number: usize, other: usize, multiple: u32) -> Option<Resonance> {
    // Of two equally fast modes the later one counts as the faster.
    let faster =
        |a: usize, b: usize| modes[a].frequency().total_cmp(&modes[b].frequency()).then(a.cmp(&b)).is_gt();
    let other_is_faster = faster(other, number);
    let (slow, fast) = if other_is_faster { (number, other) } else { (other, number) };
    let (slow, fast) = (&modes[slow], &modes[fast]);
    let detuning = fast.frequency() / (f64::from(multiple) * slow.frequency()) - 1.0;
    let proved = slow.frequency_squared.as_ref().zip(fast.frequency_squared.as_ref());
    let exact = proved.map_or(detuning.abs() < ROUNDING, |(slow, fast)| is_multiple(slow, fast, multiple));
    let detuning = if exact { 0.0 } else { detuning };
    (detuning.abs() < NEAR).then_some(Resonance { other, multiple, other_is_faster, detuning, exact })
}

fn is_multiple(slow: &Surd, fast: &Surd, multiple: u32) -> bool {
    let square = i64::from(multiple * multiple);
    slow.times(&Rational::from(square)) == *fast
}
