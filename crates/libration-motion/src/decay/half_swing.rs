//! One swing from rest to rest.
//!
//! The velocity has one sign, so that the swing is one analytic piece. A downward swing is mirrored to x″ = −Σ cₙ x′ⁿ − sin x with x′ > 0. From
//! above a right angle y = x + π is integrated, so that the distance from the top is not lost.

use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;

use super::turning::{self, arrival, departure};
use super::{Damping, DecayEnding, LEAST_AMPLITUDE, PowerLawTerm};
use crate::taylor::{Cause, Effort, IntegrationError, Moment, Step, System, integrate_stepwise};
use libration_kernels::double_double::{DoubleDouble, two_sum};
use libration_numbers::algebra::{BigFloat, Rational};
use libration_numbers::expression::{Equation, Expression, Function, Symbol};
use libration_numbers::quantity::Angle;
use libration_numbers::roots::{Tolerance, bisect};
use libration_pendulum::pendulum::Amplitude;

/// Swings of a pendulum with a given damping, ω0 = 1.
#[derive(Clone, Debug)]
pub struct HalfSwing {
    damping: Damping,
    from_bottom: GrowingCoordinate,
    pub from_top: GrowingCoordinate,
}

/// A coordinate that grows during the swing, with its equation of motion.
#[derive(Clone, Debug)]
pub struct GrowingCoordinate {
    pub system: System,
    /// The coordinate of the bottom: zero or π.
    bottom: DoubleDouble,
}

/// The duration of a swing and the amplitude at its end, or the reason why it has none; the time of an ending is that after the turning point, with
/// ω0 = 1.
pub(super) type Turn = Result<(f64, Amplitude), DecayEnding>;

/// Longest swing, in undamped half periods; a longer motion does not count as a swing.
const LONGEST: f64 = 1e3;
/// Tolerances far below the last digit, so that the error of a swing is the rounding of its steps.
pub const EFFORT: Effort = Effort { relative: 1e-17, absolute: 0.0, most_steps: 20_000 };

impl HalfSwing {
    pub fn new(damping: &Damping) -> Self {
        let frame = |gravity, bottom| GrowingCoordinate { system: system(gravity, damping), bottom };
        let sine = Expression::Call(Function::Sin, Box::new(Expression::Symbol(Symbol::plain("x"))));
        Self {
            damping: damping.clone(),
            from_bottom: frame(Expression::Negate(Box::new(sine.clone())), DoubleDouble::ZERO),
            from_top: frame(sine, DoubleDouble::PI),
        }
    }

    /// The duration of the swing that begins at this amplitude, and the amplitude at its end.
    pub(super) fn after(&self, amplitude: &Amplitude) -> Result<Turn, IntegrationError> {
        if amplitude.sine() <= self.damping.coefficient_of(0.0) {
            return Ok(Err(DecayEnding::Sticks));
        }
        let high = amplitude.radians() > FRAC_PI_2;
        let (frame, start) = match high {
            true => (&self.from_top, amplitude.complement()),
            false => (&self.from_bottom, -amplitude.radians()),
        };
        let start = self.release(start, amplitude.sine());
        let longest = 2.0 * amplitude.modulus().first() + LONGEST;
        let Some((time, coordinate)) = self.turn(frame, &start, longest)? else {
            return Ok(Err(DecayEnding::Creeps));
        };
        // Only dry friction can stop the pendulum on its way down, where it exceeds gravity.
        let is_dry = self.damping.coefficient_of(0.0) > 0.0;
        Ok(match frame.angle(coordinate) {
            angle if angle <= 0.0 && is_dry => Err(DecayEnding::StopsOnTheWay { time, angle: -angle }),
            angle if angle <= 0.0 => Err(DecayEnding::Creeps),
            angle => GrowingCoordinate::amplitude(angle).map(|amplitude| (time, amplitude)),
        })
    }

    /// The time and position at which the pendulum comes to rest; `None` if it does not within `longest`.
    fn turn(
        &self,
        frame: &GrowingCoordinate,
        start: &Moment,
        longest: f64,
    ) -> Result<Option<(f64, f64)>, IntegrationError> {
        let mut turn = None;
        let outcome = integrate_stepwise(&frame.system, start, &[start.time + longest], &EFFORT, |step| {
            turn = self.turn_in(step, frame);
            if turn.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        match outcome {
            Err(IntegrationError::Stopped { cause: Cause::Interrupted | Cause::StepLimit, .. }) | Ok(_) => {
                Ok(turn)
            }
            Err(error) => Err(error),
        }
    }

    /// An initial state for the integration: at rest, or a little later if rest has no Taylor series.
    fn release(&self, coordinate: f64, gravity: f64) -> Moment {
        if self.damping.is_analytic() {
            return Moment { time: 0.0, state: vec![coordinate, 0.0] };
        }
        let (passage, speed) = departure(gravity, &self.damping);
        Moment { time: passage.duration, state: vec![coordinate + passage.distance, speed] }
    }

    /// The time and position at which the pendulum comes to rest, if it does so in this step or shortly after it.
    fn turn_in(&self, step: &Step, frame: &GrowingCoordinate) -> Option<(f64, f64)> {
        let end = step.state_at(step.end());
        if end[1] <= 0.0 {
            let time = zero_of_velocity(step);
            return Some((time, step.state_at(time)[0]));
        }
        let gravity = frame.gravity(end[0]);
        if self.damping.is_analytic() || !turning::is_close(end[1], gravity) {
            return None;
        }
        let passage = arrival(end[1], gravity, &self.damping);
        Some((step.end() + passage.duration, end[0] + passage.distance))
    }
}

impl GrowingCoordinate {
    /// The deceleration by gravity, positive beyond the bottom.
    fn gravity(&self, coordinate: f64) -> f64 {
        libm::sin(self.angle(coordinate))
    }

    fn angle(&self, coordinate: f64) -> f64 {
        (two_sum(coordinate, -self.bottom.hi) + DoubleDouble::from(-self.bottom.lo)).to_f64()
    }

    /// The amplitude of a turning point at this angle beyond the bottom.
    fn amplitude(angle: f64) -> Result<Amplitude, DecayEnding> {
        if angle <= LEAST_AMPLITUDE {
            return Err(DecayEnding::Vanishes);
        }
        let amplitude = Angle::from_radians(angle).ok().and_then(|angle| Amplitude::new(angle).ok());
        amplitude.ok_or(DecayEnding::Creeps)
    }
}

/// x″ = gravity − Σ cₙ x′ⁿ.
fn system(gravity: Expression, damping: &Damping) -> System {
    let velocity = Expression::Symbol(Symbol::plain("x").with_primes(1));
    let drag = |term: &PowerLawTerm| {
        let power = Expression::Power(Box::new(velocity.clone()), Box::new(number(term.exponent)));
        Expression::Multiply(Box::new(number(term.coefficient)), Box::new(power))
    };
    let acceleration = damping
        .terms()
        .iter()
        .map(drag)
        .fold(gravity, |sum, drag| Expression::Subtract(Box::new(sum), Box::new(drag)));
    let equation = Equation::of_accelerations(vec!["x".to_owned()], vec![acceleration.simplified()]);
    System::new(&equation).expect("no parameter is left")
}

/// A finite number as an exact formula.
fn number(value: f64) -> Expression {
    let exact = BigFloat::from_f64(value, 64).map_or_else(|| Rational::from(0), |value| value.to_rational());
    Expression::Number(exact)
}

/// The time at which the velocity, positive inside the step but not at its end, vanishes.
fn zero_of_velocity(step: &Step) -> f64 {
    let moves = |time| step.state_at(time)[1] > 0.0;
    let [_, rest] = bisect([step.start(), step.end()], Tolerance::LAST_BIT, moves);
    rest
}
