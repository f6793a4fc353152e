//! Orbits among other closed orbits, such as those of prey and predators, or about a sun: the start selects one of them.

use super::closing::Rounds;
use super::error::OrbitError;
use super::near::OrbitGuess;
use super::periodic::Orbit;
use super::shooting::{Unknowns, closed};
use libration_numbers::expression::Equation;

/// The condition under which an orbit counts as a member of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FamilyCondition {
    /// No condition: since the energy is conserved, every orbit belongs to a family.
    Known,
    /// A neighbouring orbit must close too, since an isolated cycle could pass through the start.
    Asked,
}

/// Distance of the neighbour's start from the orbit, relative to the distance to the state half a period later. A cycle that attracts motions by
/// one part in 1e7 per turn then misses its start by the 1e-10 to which orbits are closed.
const ASIDE: f64 = 1e-3;
/// Largest change in half a period, relative to its value, of a component that is at rest.
const STILL: f64 = 1e-9;

/// The orbit of a family through the very state of a guess, for which only the period
/// is corrected; `None` if the motion from there does not close, or is isolated.
pub(super) fn through_start(
    equation: &Equation,
    rounds: &Rounds<'_>,
    guess: &OrbitGuess,
    family: FamilyCondition,
) -> Result<Option<Orbit>, OrbitError> {
    // Enough to tell a motion from rest half a period later.
    let Ok(path) = rounds.path(&guess.state, guess.period, 1e-12) else { return Ok(None) };
    let opposite = path.state_at(0.5 * guess.period);
    let moves = |(there, here): (&f64, &f64)| (there - here).abs() > STILL * here.abs();
    if !opposite.iter().zip(&guess.state).any(moves) {
        return Ok(None);
    }
    let Some(orbit) = closes(equation, rounds, guess)? else { return Ok(None) };
    if family == FamilyCondition::Asked {
        let beside = |(here, there): (&f64, &f64)| here + ASIDE * (there - here);
        let state = guess.state.iter().zip(&opposite).map(beside).collect();
        let neighbour = OrbitGuess { state, period: orbit.period() };
        if closes(equation, rounds, &neighbour)?.is_none() {
            return Ok(None);
        }
    }
    Ok(Some(orbit.one_of_a_family()))
}

fn closes(equation: &Equation, rounds: &Rounds<'_>, guess: &OrbitGuess) -> Result<Option<Orbit>, OrbitError> {
    let period_alone = Unknowns { free: vec![], period: true };
    match closed(equation, rounds, guess, &period_alone) {
        Ok(orbit) => Ok(Some(orbit)),
        Err(error @ OrbitError::Interrupted(_)) => Err(error),
        Err(_) => Ok(None),
    }
}
