//! The slow flow of a damped pendulum compared with its integration: the amplitude and the phase at any time, and the turning points.
//!
//! Time counts in 1/ω0, so that θ″ + ε·Σ cₙθ′|θ′|ⁿ⁻¹ + sin θ = 0 at ε = 1 is expanded, or with ε for the coefficient where there is only one.

use std::f64::consts::PI;

use crate::perturbation::{Gauge, SlowFlow, SlowFlowError, SlowSeries, slow_flow};
use libration_motion::decay::{Decay, PowerLawTerm};
use libration_numbers::algebra::{BigFloat, Rational};
use libration_numbers::expression::{Equation, Expression, Function, Symbol};
use libration_numbers::progress::Progress;

/// Amplitude and phase of a damped pendulum by a slow flow.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::comparison::SlowDecay;
/// use libration::decay::{Damping, Decay};
/// use libration::pendulum::Pendulum;
/// use libration::progress::Quiet;
///
/// // Drag of a fast flow from half a radian: each turning point of the integration, and the slow flow at its time.
/// let pendulum = Pendulum::from_angular_frequency(1.0)?;
/// let decay = Decay::new(pendulum, Damping::of_degree(2.0, 0.05)?, "0.5rad".parse()?)?;
/// let turns: Vec<_> = decay.swings().take(20).collect::<Result<_, _>>()?;
/// let times: Vec<f64> = turns.iter().map(|turn| turn.time).collect();
/// let slow = SlowDecay::new(&decay, 9, 3, &Quiet)?.at_times(&times);
/// for (turn, slow) in turns.iter().zip(slow) {
///     assert!((turn.amplitude.radians() - slow.amplitude).abs() < 1e-5);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SlowDecay {
    flow: SlowFlow,
    /// A′ and ψ′ by powers of A, at the value of ε.
    rates: [Vec<f64>; 2],
    omega0: f64,
    start: f64,
}

/// A state of the slow flow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowState {
    /// Time in seconds after the release.
    pub time: f64,
    /// Amplitude in radians; NaN when the slow flow has none.
    pub amplitude: f64,
    /// ψ in radians: the pendulum turns at multiples of π; NaN when the slow flow has none.
    pub phase: f64,
}

/// The reason why a decay has no slow flow.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SlowDecayError {
    /// A power of the velocity that is not whole.
    #[error(
        "the slow flow is known for whole powers of the velocity, and one is {0}: compare with the averaged law, which holds for any"
    )]
    Exponent(f64),
    /// No slow flow of this order.
    #[error(transparent)]
    SlowFlow(#[from] SlowFlowError),
}

impl SlowDecay {
    /// The slow flow of a decay with A′ to the power `order` of the amplitude and `damping_order` of the damping.
    ///
    /// # Errors
    /// Powers of the velocity that are not whole; orders out of range.
    /// [`SlowFlowError::Interrupted`] if the call is cancelled.
    pub fn new(
        decay: &Decay,
        order: usize,
        damping_order: usize,
        progress: &dyn Progress,
    ) -> Result<Self, SlowDecayError> {
        let (equation, strength) = equation(decay.scaled_terms())?;
        let flow = slow_flow(&equation, Some(SMALL), order, damping_order, &Gauge::XMax, progress)?;
        let rates = [&flow.amplitude_rate, &flow.phase_rate].map(|series| by_powers(series, strength));
        let (omega0, start) = (decay.pendulum().angular_frequency(), decay.start().radians());
        Ok(Self { flow, rates, omega0, start })
    }

    /// The series, in units of 1/ω0; the small parameter is the coefficient of the damping, or 1 where it has several terms.
    #[must_use]
    pub fn flow(&self) -> &SlowFlow {
        &self.flow
    }

    /// Amplitude and phase at times that increase, in seconds after the release.
    #[must_use]
    pub fn at_times(&self, times: &[f64]) -> Vec<SlowState> {
        let mut state = self.release();
        let mut follow = |&time: &f64| {
            state = self.followed(state, time * self.omega0 - state.time);
            SlowState { time, ..state }
        };
        times.iter().map(&mut follow).collect()
    }

    /// The release and the next turning points, `count` in all or until the slow flow has no amplitude.
    #[must_use]
    pub fn turning_points(&self, count: usize) -> Vec<SlowState> {
        let mut state = self.release();
        let mut turns = vec![];
        while turns.len() < count && state.amplitude > 0.0 && self.rate(1, state.amplitude) > 0.0 {
            turns.push(SlowState { time: state.time / self.omega0, ..state });
            state = self.next_turn(state, PI * libration_kernels::elementary::count(turns.len()));
        }
        turns
    }

    /// The state at the release, in units of 1/ω0.
    fn release(&self) -> SlowState {
        SlowState { time: 0.0, amplitude: self.start, phase: 0.0 }
    }

    /// Finds the state of this phase by Newton's method; gives the last iterate if it does not converge.
    fn next_turn(&self, mut state: SlowState, phase: f64) -> SlowState {
        for _ in 0..MOST_STEPS {
            let left = (phase - state.phase) / self.rate(1, state.amplitude);
            if left.is_nan() || left.abs() <= 4.0 * f64::EPSILON * state.time {
                break;
            }
            state = self.followed(state, left);
        }
        state
    }

    fn followed(&self, mut state: SlowState, duration: f64) -> SlowState {
        let steps = libm::ceil(duration.abs() / STEP).max(1.0);
        let length = duration / steps;
        let mut done = 0.0;
        while done < steps && state.amplitude.is_finite() {
            state = self.step(state, length);
            done += 1.0;
        }
        state
    }

    /// A step of Runge and Kutta's.
    fn step(&self, SlowState { time, amplitude, phase }: SlowState, length: f64) -> SlowState {
        let rates =
            |by: [f64; 2], part: f64| [0, 1].map(|of| self.rate(of, amplitude + part * length * by[0]));
        let first = rates([0.0; 2], 0.0);
        let second = rates(first, 0.5);
        let third = rates(second, 0.5);
        let last = rates(third, 1.0);
        let mean = [0, 1].map(|of| (first[of] + 2.0 * second[of] + 2.0 * third[of] + last[of]) / 6.0);
        let (amplitude, phase) = (amplitude + length * mean[0], phase + length * mean[1]);
        match amplitude > 0.0 && amplitude.is_finite() {
            true => SlowState { time: time + length, amplitude, phase },
            false => SlowState { time, amplitude: f64::NAN, phase: f64::NAN },
        }
    }

    fn rate(&self, of: usize, amplitude: f64) -> f64 {
        self.rates[of].iter().rev().fold(0.0, |sum, c| sum * amplitude + c)
    }
}

/// The name of ε.
const SMALL: &str = "epsilon";
/// Step in units of 1/ω0. Its error is the fifth power of the relative decrease of the amplitude in it, over 120: for a hundredth 1e-12,
/// which is far below c² and A² at any damping and amplitude.
const STEP: f64 = PI / 64.0;
/// Largest number of Newton steps; each squares the error of the phase, initially a multiple of the damping.
const MOST_STEPS: usize = 20;

/// Σₖ pₖ(A) εᵏ by powers of A.
fn by_powers(series: &SlowSeries, parameter: f64) -> Vec<f64> {
    let highest = series.iter().map(Vec::len).max().unwrap_or(0);
    let coefficient = |power: usize| {
        let of = |list: &Vec<_>| list.get(power).map_or(0.0, libration_numbers::algebra::PiSum::to_f64);
        series.iter().rev().fold(0.0, |sum, list| sum * parameter + of(list))
    };
    (0..highest).map(coefficient).collect()
}

/// The pendulum under ε times these terms, and the value of ε.
fn equation(terms: &[PowerLawTerm]) -> Result<(Equation, f64), SlowDecayError> {
    let angle = Expression::Symbol(Symbol::plain("theta"));
    let gravity = Expression::Call(Function::Sin, Box::new(angle));
    let (alone, strength) = match terms {
        [term] => (true, term.coefficient),
        _ => (false, 1.0),
    };
    let mut drag = Expression::from(0);
    for term in terms {
        let coefficient = if alone { Expression::from(1) } else { number(term.coefficient) };
        let force = Expression::Multiply(Box::new(coefficient), Box::new(power(term.exponent)?));
        drag = Expression::Add(Box::new(drag), Box::new(force));
    }
    let small = Box::new(Expression::Symbol(Symbol::plain(SMALL)));
    let all = Expression::Add(Box::new(Expression::Multiply(small, Box::new(drag))), Box::new(gravity));
    let acceleration = Expression::Negate(Box::new(all)).simplified();
    Ok((Equation::of_accelerations(vec!["theta".to_owned()], vec![acceleration]), strength))
}

/// θ′|θ′|ⁿ⁻¹.
fn power(exponent: f64) -> Result<Expression, SlowDecayError> {
    let velocity = || Box::new(Expression::Symbol(Symbol::plain("theta").with_primes(1)));
    let whole = |power: f64| Expression::Power(velocity(), Box::new(number(power)));
    if exponent.fract() != 0.0 {
        return Err(SlowDecayError::Exponent(exponent));
    }
    let is_even = (0.5 * exponent).fract() == 0.0;
    Ok(match is_even {
        _ if exponent == 0.0 => Expression::Call(Function::Sign, velocity()),
        false => whole(exponent),
        true => {
            let size = Expression::Call(Function::Abs, velocity());
            Expression::Multiply(Box::new(whole(exponent - 1.0)), Box::new(size))
        }
    })
}

/// A finite number as a formula.
fn number(value: f64) -> Expression {
    let exact = BigFloat::from_f64(value, 64).map_or_else(|| Rational::from(0), |value| value.to_rational());
    Expression::Number(exact)
}
