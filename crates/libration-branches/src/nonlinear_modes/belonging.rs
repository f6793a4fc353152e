//! Test whether an orbit that Newton's method has closed belongs to the mode.
//!
//! A state that rests closes after any time, an orbit closes after twice its period too, and beyond a separatrix there are orbits about other
//! equilibria. None of them is the mode at that amplitude, however well it closes.

use super::Reason;
use libration_motion::orbit::{Orbit, OrbitError};

/// Release of a mode from rest, displaced in one coordinate.
pub(super) struct Release<'a> {
    /// The state of rest that the mode is about.
    pub(super) rest: &'a [f64],
    /// The coordinate that is displaced.
    pub(super) coordinate: usize,
    /// The displacement.
    pub(super) amplitude: f64,
}

/// All coordinates together move by less than this part of the amplitude: a rest. On the top of a pendulum, at `f64` π, roundings have
/// become 1e-8 after the period of 17 that Newton's method ends with.
const STILL: f64 = 1e-6;
/// A period that may be wrong by more than this part of it is none. A pendulum's is known to 3e-13 of it at 179°, to 2e-9 at 179.99° and to
/// 2e-5 at 179.9999°; what is found at 180° has an error of a fifth of it, or one that is not a number.
const UNCERTAIN: f64 = 1e-4;
/// The coordinate may come farther than the amplitude by this part of it: so well the range of an orbit is known.
const FARTHER: f64 = 2e-3;
/// A state is back where it differs from the start by less than this part of the way between: a thousand times what is left of a closed
/// orbit, and less than a period doubling leaves at a step of a thousandth from where it begins.
const BACK: f64 = 1e-7;
/// Repetitions that are looked for; others are of longer motions, whose periods are far from those before.
const MOST_TURNS: u32 = 6;

impl Release<'_> {
    /// Reason why this orbit does not belong to the mode; `None` where it does.
    pub(super) fn refusal(&self, orbit: &Orbit) -> Option<Reason> {
        let start = orbit.start();
        let swing = |number: usize| {
            let (low, high) = orbit.range(number);
            high - low
        };
        let largest = (0..self.rest.len()).map(swing).fold(0.0, f64::max);
        // NaN too, which compares with nothing.
        if !matches!(largest.partial_cmp(&(STILL * self.amplitude)), Some(std::cmp::Ordering::Greater)) {
            return Some(OrbitError::AtRest(start[..self.rest.len()].to_vec()).into());
        }
        let (period, uncertainty) = (orbit.period(), orbit.period_uncertainty());
        if !matches!(uncertainty.partial_cmp(&(UNCERTAIN * period)), Some(std::cmp::Ordering::Less)) {
            return Some(Reason::Unsure { period, uncertainty });
        }
        self.elsewhere(orbit).or_else(|| turns(orbit, &start).map(Reason::Repetition))
    }

    /// Reason for refusal if the coordinate stays on one side of its place of rest, or comes farther than it was released.
    fn elsewhere(&self, orbit: &Orbit) -> Option<Reason> {
        let centre = self.rest[self.coordinate];
        let (low, high) = orbit.range(self.coordinate);
        if low < centre && high - centre <= (1.0 + FARTHER) * self.amplitude {
            return None;
        }
        if low < centre {
            return Some(Reason::Farther { amplitude: self.amplitude, displacement: high - centre });
        }
        let start = centre + self.amplitude;
        let other_side = if high - start > start - low { high } else { low };
        Some(OrbitError::Elsewhere { start, other_side, centre }.into())
    }
}

/// Number of turns of a shorter orbit that the orbit consists of; `None` where there is no shorter one.
fn turns(orbit: &Orbit, start: &[f64]) -> Option<u32> {
    let distance = |state: &[f64]| {
        let squares = state.iter().zip(start).map(|(a, b)| (a - b) * (a - b));
        libm::sqrt(squares.sum())
    };
    let after = |part: f64| distance(&orbit.state_at(part * orbit.period()));
    (2..=MOST_TURNS).find(|turns| {
        let turn = 1.0 / f64::from(*turns);
        // From a turning point half a turn leads to the other one.
        after(turn) < BACK * after(0.5 * turn)
    })
}
