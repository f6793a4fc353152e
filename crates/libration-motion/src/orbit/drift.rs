//! Weak limit cycles, for which the drift in one turn is too small to distinguish the turn from a cycle: x″ = μ(1 − x²)x′ − x with a small μ.
//!
//! From such a turn Newton's method leads to the equilibrium that the motion leaves, where the growth of deviations still dominates. The drift
//! in one turn is the slope of a slow motion, which is followed in leaps of many turns until Newton's method leads to the cycle.

use super::closing::Rounds;
use super::error::OrbitError;
use super::near::OrbitGuess;
use crate::periodic::norm;

/// Change of the state in one leap, relative to its way in half a turn. From a fourth of its amplitude, van der Pol's cycle is reached by
/// Newton's method, which succeeds from three fifths on, after seven leaps.
const LEAP: f64 = 0.15;
/// Maximum number of leaps, in which an amplitude grows by e⁹ = 8000.
pub(super) const MOST_LEAPS: usize = 60;

/// The maximum after one leap in the direction of the drift in one turn; `None` if the coordinate has no velocity, or does not turn.
pub(super) fn leap(
    rounds: &Rounds<'_>,
    coordinate: usize,
    from: &OrbitGuess,
) -> Result<Option<OrbitGuess>, OrbitError> {
    let Some(velocity) = rounds.layout().velocity(coordinate) else { return Ok(None) };
    // The drift in one turn may be a small part of the motion: as exact as rounding allows.
    let Some(path) = rounds.turn(coordinate, from, 1e-16)? else { return Ok(None) };
    let period = path.end_time();
    let drift = difference(&path.state_at(period), &from.state);
    let way = norm(&difference(&path.state_at(0.5 * period), &from.state));
    let turns = LEAP * way / norm(&drift);
    if !turns.is_finite() {
        return Ok(None);
    }
    let mut state: Vec<f64> = from.state.iter().zip(&drift).map(|(x, slope)| x + turns * slope).collect();
    state[velocity] = 0.0;
    Ok(Some(OrbitGuess { state, period }))
}

fn difference(to: &[f64], from: &[f64]) -> Vec<f64> {
    to.iter().zip(from).map(|(to, from)| to - from).collect()
}
