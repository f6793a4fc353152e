//! The manifolds of the upright position, followed by integration to the bottom and compared there.
//!
//! If a motion starts near the saddle orbit, its distance from the unstable manifold at the bottom is of the
//! order of the square of its initial distance: components off the manifold have decayed by the same factor
//! by which the component along it has grown. The direction of the manifold therefore need not be known.

use std::f64::consts::PI;

use super::TangencyError;
use super::saddle::Saddle;
use libration_motion::taylor::{Effort, Event, Moment, System, integrate};
use libration_numbers::expression::{Equation, Expression, Symbol};
use libration_numbers::internals::progress::Watch;

/// Tolerance below the rounding error of an `f64`, so that the truncation of the series does not count.
const TOLERANCE: f64 = 1e-16;
/// Longest time to the bottom, in units of 1/ω0: several times that of a motion that started at 1e-9 of the saddle.
const LONGEST: f64 = 100.0;

/// The manifolds that leave the upright position on one side and arrive on the other.
pub(super) struct Manifolds<'a> {
    motion: System,
    /// Saddles from which the manifolds leave and at which they arrive.
    saddles: [Saddle; 2],
    direction: f64,
    omega0: f64,
    /// Distance of the starts from the saddles, in radians.
    distance: f64,
    watch: &'a Watch<'a>,
}

/// A passage of the bottom.
#[derive(Clone, Copy)]
struct Passage {
    time: f64,
    velocity: f64,
}

/// Times from the starts to their passages of the bottom, in seconds: positive from the saddle, negative to it.
pub(super) type Delays = [f64; 2];

impl<'a> Manifolds<'a> {
    pub(super) fn new(
        equation: &Equation,
        [direction, omega0, frequency]: [f64; 3],
        distance: f64,
        watch: &'a Watch<'a>,
    ) -> Result<Self, TangencyError> {
        let angle = Expression::Symbol(Symbol::plain(&equation.variables()[0]));
        let bottom = Event { ends_at: Some(1), ..Event::zero_of(angle) };
        let motion = System::new(equation)?.with_events(&[bottom])?;
        let saddle = |side: f64| Saddle::new(equation, side * PI, [omega0, frequency]);
        let saddles = [saddle(-direction)?, saddle(direction)?];
        Ok(Self { motion, saddles, direction, omega0, distance, watch })
    }

    pub(super) fn delays(&self) -> Delays {
        let delay = libm::log(4.0 / self.distance) / self.omega0;
        [delay, -delay]
    }

    /// Energy per m·l² of the unstable manifold minus that of the stable one, when
    /// they pass the bottom at this time, and the velocity of the unstable one.
    pub(super) fn separation(&self, time: f64, delays: &mut Delays) -> Result<[f64; 2], TangencyError> {
        let [leaving, arriving] = [0, 1].map(|end| self.velocity_at(time, end, &mut delays[end]));
        let (leaving, arriving) = (leaving?, arriving?);
        Ok([0.5 * (leaving - arriving) * (leaving + arriving), leaving])
    }

    /// The velocity with which a manifold passes the bottom at a time; a later start gives a later passage. A rounding error of the start,
    /// relative to its distance from the saddle, makes the time of the passage uncertain, and the last two passages give the resulting error.
    fn velocity_at(&self, time: f64, end: usize, delay: &mut f64) -> Result<f64, TangencyError> {
        const TRIES: usize = 30;
        /// Distance of a passage from the time wanted, in units of 1/ω0: the square of it, which the slope leaves, is below rounding.
        const NEAR: f64 = 1e-8;
        let mut start = time - *delay;
        let mut last = self.passage(start - NEAR.sqrt() / self.omega0, end)?;
        for _ in 0..TRIES {
            let passage = self.passage(start, end)?;
            let late = passage.time - time;
            *delay = passage.time - start;
            if late.abs() * self.omega0 <= NEAR {
                let slope = (passage.velocity - last.velocity) / (passage.time - last.time);
                return Ok(passage.velocity - slope * late);
            }
            start -= late;
            last = passage;
        }
        Err(TangencyError::NoConvergence)
    }

    fn passage(&self, time: f64, end: usize) -> Result<Passage, TangencyError> {
        let inward = if end == 0 { self.direction } else { -self.direction };
        let saddle = self.saddles[end].state_at(time);
        let velocity = saddle[1] + self.direction * self.omega0 * self.distance;
        let start = Moment { time, state: vec![saddle[0] + inward * self.distance, velocity] };
        let until = if end == 0 { LONGEST } else { -LONGEST } / self.omega0;
        let effort = Effort::to_tolerance(TOLERANCE);
        let solution = integrate(&self.motion, &start, &[time + until], &effort, &self.watch.part())?;
        let bottom = solution.events.first().ok_or(TangencyError::NoPassage)?;
        Ok(Passage { time: bottom.time, velocity: bottom.state[1] })
    }
}
