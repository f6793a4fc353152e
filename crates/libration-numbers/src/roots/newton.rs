//! Newton's method for zeros of n functions of n unknowns, over any field.

use crate::algebra::Ring;
use crate::expression::{jet::Jet, tape::Tape};
use crate::linear::elimination::solve;

/// The reason why Newton's method fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NewtonError {
    /// A function has no finite value.
    NoValue,
    /// The Jacobian matrix is singular or has no value.
    NoSlope,
    /// The step limit was reached.
    Unsettled,
}

/// The point at which Newton's method failed, and the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Unsolved<T> {
    /// The last point.
    pub at: Vec<T>,
    /// The reason.
    pub reason: NewtonError,
}

/// The zero that Newton's method reaches from a guess, or else the last point and the reason. `step` returns the correction at a point;
/// `is_last` returns `true` if, after this correction and with this new point, no further one is needed.
pub fn newton<R: Ring>(
    ring: &R,
    guess: &[R::Element],
    most_steps: usize,
    mut step: impl FnMut(&[R::Element]) -> Result<Vec<R::Element>, NewtonError>,
    mut is_last: impl FnMut(&[R::Element], &[R::Element]) -> bool,
) -> Result<Vec<R::Element>, Unsolved<R::Element>> {
    let mut at = guess.to_vec();
    for _ in 0..most_steps {
        let change = match step(&at) {
            Ok(change) => change,
            Err(reason) => return Err(Unsolved { at, reason }),
        };
        at = at.iter().zip(&change).map(|(x, change)| ring.add(x, change)).collect();
        if is_last(&change, &at) {
            return Ok(at);
        }
    }
    Err(Unsolved { at, reason: NewtonError::Unsettled })
}

/// The correction −F′⁻¹·F at a point, for formulas on a tape; zero if all of them vanish.
pub fn correction<R: Ring>(
    ring: &R,
    size: impl Fn(&R::Element) -> f64,
    tape: &Tape,
    at: &[R::Element],
) -> Result<Vec<R::Element>, NewtonError> {
    let jet = Jet::new(ring, tape, at).map_err(|_| NewtonError::NoValue)?;
    let value: Vec<R::Element> = (0..at.len()).map(|i| ring.negate(&jet.result(i)[0])).collect();
    if value.iter().all(|x| ring.is_zero(x)) {
        return Ok(value);
    }
    if !value.iter().all(|x| size(x).is_finite()) {
        return Err(NewtonError::NoValue);
    }
    let gains: Result<Vec<Vec<R::Element>>, _> = (0..at.len()).map(|j| jet.gains(j)).collect();
    let gains = gains.map_err(|_| NewtonError::NoSlope)?;
    let row = |i: usize| gains.iter().map(|gain| gain[tape.results()[i]].clone()).collect();
    let slopes: Vec<Vec<R::Element>> = (0..at.len()).map(row).collect();
    let step = solve(ring, &size, &slopes, &value);
    step.filter(|step| step.iter().all(|x| size(x).is_finite())).ok_or(NewtonError::NoSlope)
}
