//! Limit cycles that do not depend on their start after one turn, such as relaxation oscillations: x″ = μ(1 − x²)x′ − x with a large μ.
//!
//! In one turn a deviation shrinks by exp ∮ ∂F/∂x′ dt (Liouville), for van der Pol's oscillator with large μ by about
//! e^(−2.9μ²). If this is below the last bit, every start leads to the same end, and the turn that begins there is
//! the cycle. Newton's method and the variational equations, in which all digits would be lost, cannot improve it.
//!
//! # Method
//! Such a cycle is one turn from any start, and its multiplier is known by its logarithm, ∮ ∂F/∂x′
//! dt. The method is used if the logarithm is below −40, so that a deviation shrinks to e⁻⁴⁰ = 4e-18.

use super::closing::Rounds;
use super::divergence::Divergence;
use super::error::OrbitError;
use super::near::OrbitGuess;
use super::path::Path;
use super::periodic::{Orbit, OrbitErrors};
use crate::periodic::Floquet;
use libration_numbers::expression::Equation;

/// Logarithm of a multiplier below which one turn shrinks a deviation as large as the orbit to less than the last bit of a state: e⁻⁴⁰ = 4e-18.
const FORGOTTEN: f64 = -40.0;

/// Relative difference from the period of the guess up to which a turn to the next maximum is the whole
/// cycle, and not a part of one with several maxima: the guess has returned to a thousandth of the swing.
const SAME_PERIOD: f64 = 0.01;

/// The relative error of a multiplier from the quadrature of the divergence, if the multiplier does not underflow.
const LOGARITHM: f64 = 1e-6;

/// The cycle near a guess; `None` if deviations do not vanish in a turn.
pub(super) fn forgetful(
    equation: &Equation,
    rounds: &Rounds<'_>,
    guess: &OrbitGuess,
) -> Result<Option<Orbit>, OrbitError> {
    // At a jump of a force the volume of deviations jumps too.
    let Some(divergence) = Divergence::new(equation).filter(|_| !rounds.has_jumps()) else { return Ok(None) };
    let Some(first) = rounds.turn(0, guess, 1e-17)? else { return Ok(None) };
    let is_whole = (first.end_time() / guess.period - 1.0).abs() < SAME_PERIOD;
    let forgets = divergence.along(&first) < FORGOTTEN;
    if !is_whole || !forgets {
        return Ok(None);
    }
    let (first_start, first_period) = (guess.state[0], first.end_time());
    let start = turned(&first);
    // A turn may have about 1e5 steps.
    drop(first);
    let Some(path) = rounds.turn(0, &start, 1e-17)? else { return Ok(None) };
    let Some(again) = rounds.turn(0, &start, 1e-16)? else { return Ok(None) };
    let (other, apart) = (again.end_time(), path.apart(&again));
    drop(again);
    let period = path.end_time();
    let missed = (path.state_at(period)[0] - start.state[0]).abs();
    // The change of the period with the start, from both turns.
    let slope = (first_period - period) / (first_start - start.state[0]);
    let late = if slope.is_finite() { missed * slope.abs() } else { 0.0 };
    let uncertainty = 4.0 * ((period - other).abs() + late + f64::EPSILON * period);
    // The start is the end of a previous turn, and does not depend on where that began.
    let start_errors = vec![4.0 * (missed + f64::EPSILON * start.state[0].abs()), 0.0];
    let apart: Vec<f64> = apart.iter().map(|distance| 4.0 * distance).collect();
    let grown = start_errors.clone();
    let errors = OrbitErrors::new(&path, start_errors, &grown, &apart, uncertainty);
    // The error of the integral over many steps is proportional to its size.
    let floquet = Floquet::of_cycle(divergence.along(&path), LOGARITHM);
    Ok(Some(Orbit::new(equation, path, uncertainty, Some(floquet), errors)))
}

/// The maximum at the end of a turn.
fn turned(path: &Path) -> OrbitGuess {
    OrbitGuess { state: vec![path.state_at(path.end_time())[0], 0.0], period: path.end_time() }
}
