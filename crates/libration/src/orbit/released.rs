//! One coordinate released from rest, until it is back.

use super::error::{Lost, NoOrbit};
use super::path::{Path, sign_change, until};
use super::periodic::Orbit;
use crate::expression::{Equation, Expression, Symbol};
use crate::taylor::{Cause, Effort, IntegrationError, Moment, Step, System};

/// Steps of one half of an oscillation; more are taken only by motions without end.
const MOST_STEPS: usize = 20_000;
/// A period that may be wrong by more than this part of it is none.
const UNCERTAIN: f64 = 1e-4;
/// Further off than this part of the swing an oscillation does not end where it began.
const CLOSED: f64 = 1e-6;

impl Orbit {
    /// The motion of one coordinate that is released from rest at a place: to the other turning point and back. It is
    /// periodic where the energy is conserved, or where the force is the same for the opposite velocity.
    ///
    /// # Accuracy
    /// As [`period_uncertainty`](Self::period_uncertainty) says: some units in the last place, and near an unstable
    /// equilibrium what becomes of them on the way.
    ///
    /// # Errors
    /// Several coordinates or the time in the equation, a release in an equilibrium, and motions that do not come
    /// back to where they began.
    ///
    /// # Examples
    /// ```
    /// use libration::orbit::Orbit;
    /// let orbit = Orbit::released(&"x'' = -x^3".parse()?, 2.0)?;
    /// // Γ(1/4)²/√π over the amplitude.
    /// assert!((orbit.period() - 7.416298709205487 / 2.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn released(equation: &Equation, place: f64) -> Result<Self, NoOrbit> {
        let [_] = equation.variables() else {
            return Err(NoOrbit::SeveralCoordinates(equation.variables().len()));
        };
        if depends_on_time(equation) {
            return Err(NoOrbit::DependsOnTime);
        }
        if !place.is_finite() {
            return Err(NoOrbit::Start { state: vec![place], wanted: 1 });
        }
        let system = System::new(equation)?;
        let around = |tolerance| match once_around(&system, place, tolerance) {
            Err(NoOrbit::NotClosed { start, .. }) if is_free_of_velocity(equation) => {
                Err(NoOrbit::Separatrix(start))
            }
            other => other,
        };
        let path = around(1e-17)?;
        // Other orders and lengths of the steps make other rounding errors.
        let again = around(1e-16)?;
        let (period, half) = (path.full.end_time(), path.half);
        let spread = (period - again.full.end_time()).abs().max((period - 2.0 * half).abs());
        let uncertainty = 4.0 * (spread + f64::EPSILON * period);
        if uncertainty > UNCERTAIN * period {
            return Err(NoOrbit::Unsure { start: place, period, uncertainty });
        }
        Ok(Self::new(equation, path.full, uncertainty, None))
    }
}

/// An oscillation and the time of the first half of it.
struct Around {
    full: Path,
    half: f64,
}

fn once_around(system: &System, place: f64, tolerance: f64) -> Result<Around, NoOrbit> {
    let start = Moment { time: 0.0, state: vec![place, 0.0] };
    let effort = Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(tolerance) };
    let there = to_rest(system, &start, place, &effort)?;
    let half = there.end_time();
    let other_side = Moment { time: half, state: vec![there.state_at(half)[0], 0.0] };
    let full = there.followed_by(to_rest(system, &other_side, place, &effort)?);
    let end = full.state_at(full.end_time())[0];
    let (swing, back) = ((place - other_side.state[0]).abs(), (end - other_side.state[0]).abs());
    if back < CLOSED * swing {
        return Err(NoOrbit::NoReturn { start: place, why: Lost::Rest });
    }
    if (end - place).abs() > CLOSED * swing {
        return Err(NoOrbit::NotClosed { start: place, end });
    }
    Ok(Around { full, half })
}

/// From rest to the next rest.
fn to_rest(system: &System, start: &Moment, place: f64, effort: &Effort) -> Result<Path, NoOrbit> {
    const FAR: f64 = 1e100;
    let mut moves = true;
    let happens = |step: &Step<'_>| {
        moves = moves && is_moving(step);
        if moves { sign_change(step, 1) } else { Some(step.end()) }
    };
    let found = until(system, start, FAR, effort, happens);
    if !moves {
        return Err(NoOrbit::AtRest(vec![start.state[0]]));
    }
    let lost = |why| NoOrbit::NoReturn { start: place, why };
    match found {
        Ok(Some(path)) => Ok(path),
        Ok(None) => Err(lost(Lost::OneWay(FAR))),
        Err(error) => Err(lost(why_lost(error))),
    }
}

fn is_moving(step: &Step<'_>) -> bool {
    step.state_at(0.5 * (step.start() + step.end()))[1] != 0.0
}

fn why_lost(error: IntegrationError) -> Lost {
    match error {
        IntegrationError::Stopped { cause: Cause::StepLimit, solution } => Lost::OneWay(solution.end.time),
        other => Lost::Stopped(other),
    }
}

/// Whether the force is one of the place only, which conserves an energy.
fn is_free_of_velocity(equation: &Equation) -> bool {
    let mut velocities = equation.variables().iter().map(|name| Symbol::plain(name).with_primes(1));
    velocities.all(|velocity| equation.accelerations().iter().all(|formula| !formula.contains(&velocity)))
}

/// Whether the time stands in one of the accelerations.
pub(super) fn depends_on_time(equation: &Equation) -> bool {
    let time = Symbol::plain("t");
    equation.accelerations().iter().any(|formula: &Expression| formula.contains(&time))
}
