//! Limit cycles that forget their start within a turn, as relaxation oscillations do: x″ = μ(1 − x²)x′ − x with a large μ.
//!
//! In one turn a deviation shrinks by exp ∮ ∂F/∂x′ dt (Liouville), for van der Pol's oscillator about e^(−2.9μ²) when μ is large. Below the last
//! bit every start leads to the same end: the turn that begins there is the cycle, and neither Newton's method nor the equations of small
//! deviations, in which all digits would be lost, can add to it.

use super::closing::Rounds;
use super::error::NoOrbit;
use super::floquet::{Divergence, Floquet};
use super::near::OrbitGuess;
use super::path::Path;
use super::periodic::Orbit;
use libration_numbers::expression::Equation;

/// A deviation as large as the orbit is below its last bit after a turn with this logarithm: e⁻⁴⁰ = 4e-18.
const FORGOTTEN: f64 = -40.0;

/// A turn to the next maximum is the whole cycle, and not a part of one with several maxima, where it takes the period of the guess to this
/// part: the guess has returned to a thousandth of the swing.
const SAME_PERIOD: f64 = 0.01;

/// The cycle near a guess; `None` where deviations are not forgotten.
pub(super) fn forgetful(
    equation: &Equation,
    rounds: &Rounds<'_>,
    guess: &OrbitGuess,
) -> Result<Option<Orbit>, NoOrbit> {
    let Some(divergence) = Divergence::new(equation) else { return Ok(None) };
    let Some(first) = rounds.turn(guess, 1e-17)? else { return Ok(None) };
    let is_whole = (first.end_time() / guess.period - 1.0).abs() < SAME_PERIOD;
    let forgets = divergence.along(&first) < FORGOTTEN;
    if !is_whole || !forgets {
        return Ok(None);
    }
    let (first_start, first_period) = (guess.state[0], first.end_time());
    let start = turned(&first);
    // A turn may have some 1e5 steps.
    drop(first);
    let Some(path) = rounds.turn(&start, 1e-17)? else { return Ok(None) };
    let other = rounds.turn(&start, 1e-16)?.map(|path| path.end_time());
    let Some(other) = other else { return Ok(None) };
    let period = path.end_time();
    let missed = (path.state_at(period)[0] - start.state[0]).abs();
    // How much the period changes with the start, as both turns tell.
    let slope = (first_period - period) / (first_start - start.state[0]);
    let late = if slope.is_finite() { missed * slope.abs() } else { 0.0 };
    let uncertainty = 4.0 * ((period - other).abs() + late + f64::EPSILON * period);
    let floquet = Floquet::of_cycle(divergence.along(&path));
    Ok(Some(Orbit::new(equation, path, uncertainty, Some(floquet))))
}

/// The maximum at the end of a turn.
fn turned(path: &Path) -> OrbitGuess {
    OrbitGuess { state: vec![path.state_at(path.end_time())[0], 0.0], period: path.end_time() }
}
