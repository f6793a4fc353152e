//! Test whether an orbit from Newton's method belongs to the mode.
//!
//! An equilibrium closes after any time, an orbit closes after twice its period too, and beyond a separatrix there are orbits about other
//! equilibria. None of these is the mode at the requested amplitude, however well it closes.

use super::Reason;
use libration_motion::orbit::{Orbit, OrbitError};
use std::f64::consts::TAU;

/// Release of a mode from rest, displaced in one coordinate.
pub(super) struct Release<'a> {
    /// The equilibrium of the mode.
    pub(super) rest: &'a [f64],
    /// The index of the displaced coordinate.
    pub(super) coordinate: usize,
    /// The displacement.
    pub(super) amplitude: f64,
}

/// Motion, relative to the amplitude and in all coordinates together, below which the orbit is an equilibrium. At the top of a pendulum, at
/// `f64` π, rounding errors have grown to 1e-8 after the period of 17 with which Newton's method ends.
const STILL: f64 = 1e-6;
/// Relative error above which a period is not determined. The period of a pendulum has a relative error of 3e-13 at 179°, 2e-9 at 179.99° and
/// 2e-5 at 179.9999°; the result at 180° has an error of a fifth, or NaN.
const UNCERTAIN: f64 = 1e-4;
/// Relative distance by which the coordinate may exceed the amplitude: the accuracy of the range of an orbit.
const FARTHER: f64 = 2e-3;
/// Distance from the start, relative to the distance in between, below which a state has returned: a thousand times the residual of a closed
/// orbit, and less than the distance after a period doubling at a step of a thousandth.
const BACK: f64 = 1e-7;
/// Largest number of repetitions that is tested; more repetitions belong to longer motions, whose periods are far from the previous ones.
const MOST_TURNS: u32 = 6;

impl Release<'_> {
    /// Reason why this orbit does not belong to the mode; `None` if it does.
    pub(super) fn refusal(&self, orbit: &Orbit) -> Option<Reason> {
        let start = orbit.start();
        let swing = |number: usize| {
            let (low, high) = orbit.range(number);
            high - low
        };
        let largest = (0..self.rest.len()).map(swing).fold(0.0, f64::max);
        // Also true for NaN, which cannot be compared.
        if !matches!(largest.partial_cmp(&(STILL * self.amplitude)), Some(std::cmp::Ordering::Greater)) {
            return Some(OrbitError::AtRest(start[..self.rest.len()].to_vec()).into());
        }
        let (period, uncertainty) = (orbit.period(), orbit.period_uncertainty());
        if !matches!(uncertainty.partial_cmp(&(UNCERTAIN * period)), Some(std::cmp::Ordering::Less)) {
            return Some(Reason::Unsure { period, uncertainty });
        }
        self.elsewhere(orbit).or_else(|| turns(orbit, &start).map(Reason::Repetition))
    }

    /// Reason for rejection if the coordinate stays on one side of its equilibrium, or exceeds its release point.
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

/// Number of repetitions of a shorter orbit of which the orbit consists; `None` if there is no shorter one.
fn turns(orbit: &Orbit, start: &[f64]) -> Option<u32> {
    let pace = TAU / orbit.period();
    let distance = |state: &[f64]| {
        let units = (0..).map(|number| if 2 * number < start.len() { 1.0 } else { pace });
        let apart = state.iter().zip(start).zip(units).map(|((a, b), unit)| (a - b) / unit);
        libm::sqrt(apart.map(|x| x * x).sum())
    };
    let after = |part: f64| distance(&orbit.state_at(part * orbit.period()));
    (2..=MOST_TURNS).find(|turns| {
        let turn = 1.0 / f64::from(*turns);
        // From a turning point, half a period leads to the other one.
        after(turn) < BACK * after(0.5 * turn)
    })
}
