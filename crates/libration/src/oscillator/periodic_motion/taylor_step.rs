//! One step of an equation of motion by its Taylor series.

use super::super::model::{Kind, Oscillator};
use crate::algebra::Doubles;
use crate::expression::{Jet, Symbol, Tape};

/// The order of the series: with steps of a fifth of the radius of convergence, 5^−24 is below the last bit.
const ORDER: u32 = 24;
const PART_OF_RADIUS: f64 = 0.2;

/// Position and velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) x: f64,
    pub(super) velocity: f64,
}

/// The equation of motion, prepared for integration.
#[derive(Clone, Debug)]
pub(super) struct Rates {
    acceleration: Tape,
    strength: Option<f64>,
    /// The size of the motion, of which errors are counted as parts.
    size: f64,
}

/// The position as a polynomial of the time since `start`.
#[derive(Clone, Debug)]
pub(super) struct TaylorStep {
    pub(super) start: f64,
    pub(super) length: f64,
    pub(super) coefficients: Vec<f64>,
}

impl Rates {
    /// `None` when a strength is given for another oscillator than one with a limit cycle, or is not given for one.
    pub(super) fn new(oscillator: &Oscillator, size: f64, strength: Option<f64>) -> Option<Self> {
        let x = Symbol::plain(oscillator.variable());
        let mut inputs = vec![x.clone(), x.with_primes(1)];
        match (oscillator.kind(), strength) {
            (Kind::LimitCycle { parameter }, Some(_)) => inputs.push(Symbol::plain(parameter)),
            (Kind::LimitCycle { .. }, None) | (_, Some(_)) => return None,
            _ => {}
        }
        let acceleration = Tape::new(&[oscillator.acceleration()], &inputs).ok()?;
        Some(Self { acceleration, strength, size })
    }

    /// The step that begins in a state; `None` where the acceleration has no value.
    pub(super) fn step_from(&self, state: State) -> Option<TaylorStep> {
        let inputs = |x, velocity, strength: Option<f64>| {
            [x, velocity].into_iter().chain(strength).collect::<Vec<f64>>()
        };
        let mut coefficients = vec![state.x, state.velocity];
        let mut jet =
            Jet::new(&Doubles, &self.acceleration, &inputs(state.x, state.velocity, self.strength)).ok()?;
        for (n, divisor) in (1_usize..).zip(1..ORDER) {
            // xₙ₊₁ = Fₙ₋₁/(n(n + 1)), and the velocity's n-th coefficient is (n + 1)·xₙ₊₁.
            let velocity = jet.result(0)[n - 1] / f64::from(divisor);
            coefficients.push(velocity / f64::from(divisor + 1));
            jet.extend(&inputs(coefficients[n], velocity, self.strength.map(|_| 0.0))).ok()?;
        }
        let length = PART_OF_RADIUS * self.radius(&coefficients)?;
        Some(TaylorStep { start: 0.0, length, coefficients })
    }

    /// The radius of convergence as the last coefficients tell it, some of which may be small by chance.
    fn radius(&self, coefficients: &[f64]) -> Option<f64> {
        const LAST: u32 = 8;
        let part = |n: usize| self.size / coefficients[n].abs();
        let by = |n: u32| libm::pow(part(usize::try_from(n).unwrap_or(0)), 1.0 / f64::from(n));
        let radius = (ORDER - LAST..=ORDER).map(by).fold(f64::INFINITY, f64::min);
        (radius.is_finite() && radius > 0.0).then_some(radius)
    }
}

impl TaylorStep {
    /// The acceleration at its beginning.
    pub(super) fn acceleration(&self) -> f64 {
        2.0 * self.coefficients[2]
    }

    /// Position and velocity some time after its beginning.
    pub(super) fn state_at(&self, time: f64) -> State {
        let (mut x, mut velocity) = (0.0, 0.0);
        for c in self.coefficients.iter().rev() {
            velocity = velocity * time + x;
            x = x * time + c;
        }
        State { x, velocity }
    }

    /// When the velocity, which has this direction before, vanishes.
    pub(super) fn time_of_rest(&self, direction: f64) -> f64 {
        // A step that begins at rest is in motion soon after.
        const SOON: f64 = 1e-3;
        let begins_at_rest = self.coefficients[1] == 0.0;
        let mut moving = if begins_at_rest { SOON * self.length } else { 0.0 };
        let mut returning = self.length;
        loop {
            let middle = 0.5 * (moving + returning);
            if middle <= moving || middle >= returning {
                return returning;
            }
            let moves = self.state_at(middle).velocity * direction > 0.0;
            if moves { moving = middle } else { returning = middle }
        }
    }
}
