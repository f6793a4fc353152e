//! The work of a weak force over an orbit that is none of its making.
//!
//! W(A) = ∮ f(x, x′) x′ dt over the orbit of x″ = F(x) that is released from rest at A. Its derivative by the energy needs no difference of
//! orbits: ∂x′/∂E = 1/x′ at a place x, so that dW/dE = ∮ ∂f/∂x′ dt, and at the turning points what f jumps by there, over F.

use super::enclosed::other_equilibrium;
use libration_motion::orbit::{Orbit, OrbitError};
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::progress::Watch;
use libration_numbers::quadrature::{Integral, gauss_kronrod};
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// A force over the orbits of an oscillator.
#[derive(Debug)]
pub struct WorkOverOrbits<'a> {
    pub(super) equation: &'a Equation,
    pub(super) centre: f64,
    /// F, then f and ∂f/∂x′.
    tape: Tape,
}

/// The work that a force does over an orbit.
#[derive(Clone, Copy, Debug)]
pub struct Work {
    pub(super) amplitude: f64,
    /// The displacement at the other turning point.
    pub(super) other_side: f64,
    pub(super) period: f64,
    pub(super) period_uncertainty: f64,
    /// W, with an error of at most `uncertainty`.
    pub value: f64,
    pub uncertainty: f64,
    /// dW/dE, with an error of at most `slope_uncertainty`.
    pub(super) slope: f64,
    pub(super) slope_uncertainty: f64,
    /// dE/dA, the force at the turning point.
    pub(super) energy_slope: f64,
}

impl Work {
    /// Returns `true` if the work is certainly not zero.
    pub(super) fn is_some(&self) -> bool {
        self.value.abs() > self.uncertainty
    }
}

impl<'a> WorkOverOrbits<'a> {
    pub fn new(equation: &'a Equation, force: &Expression, centre: f64) -> Option<Self> {
        let x = Symbol::plain(equation.variables().first()?);
        let velocity = x.with_primes(1);
        let slope = force.derivative(&velocity).simplified();
        let tape = Tape::new(&[&equation.accelerations()[0], force, &slope], &[x, velocity]).ok()?;
        Some(Self { equation, centre, tape })
    }

    /// F, f and ∂f/∂x′.
    fn forces(&self, state: &[f64]) -> [f64; 3] {
        let jet = Jet::new(&Doubles, &self.tape, state);
        jet.map_or([f64::NAN; 3], |jet| [0, 1, 2].map(|index| jet.result(index)[0]))
    }

    /// The work over the orbit of an amplitude, in the family about the centre.
    pub fn at(&self, amplitude: f64, watch: &Watch<'_>) -> Result<Work, OrbitError> {
        let (centre, start) = (self.centre, self.centre + amplitude);
        let elsewhere = |other_side: f64| OrbitError::Elsewhere { start, other_side, centre };
        let encloses = |ends: [f64; 2]| other_equilibrium(self.equation, centre, ends).is_some();
        // Beyond a separatrix nothing needs to be integrated.
        if encloses([start, start]) {
            return Err(elsewhere(start));
        }
        let orbit = Orbit::released(self.equation, start, watch)?;
        let period = orbit.period();
        let other = orbit.state_at(0.5 * period)[0];
        if other >= centre || encloses([other, start]) {
            return Err(elsewhere(other));
        }
        let over = |of: &dyn Fn(&[f64]) -> f64| over_halves(&orbit, of);
        let [work, size] = [
            over(&|state| self.forces(state)[1] * state[1]),
            over(&|state| (self.forces(state)[1] * state[1]).abs()),
        ];
        let [slope, slope_size] =
            [over(&|state| self.forces(state)[2]), over(&|state| self.forces(state)[2].abs())];
        let turns = [self.jump(start), self.jump(other)];
        // What an orbit is wrong by is at least what its period is.
        let part = ROUNDINGS * (f64::EPSILON + orbit.period_uncertainty() / period);
        Ok(Work {
            amplitude,
            other_side: other - centre,
            period,
            period_uncertainty: orbit.period_uncertainty(),
            value: work.value,
            uncertainty: work.error + part * size.value,
            slope: slope.value + turns[0] + turns[1],
            slope_uncertainty: slope.error + part * (slope_size.value + turns[0].abs() + turns[1].abs()),
            energy_slope: -self.forces(&[start, 0.0])[0],
        })
    }

    /// The jump of f at a turning point, upwards in the velocity, divided by the force that turns the motion.
    fn jump(&self, displacement: f64) -> f64 {
        let [above, below] =
            [f64::MIN_POSITIVE, -f64::MIN_POSITIVE].map(|velocity| self.forces(&[displacement, velocity])[1]);
        if above.total_cmp(&below).is_eq() {
            0.0
        } else {
            (above - below) / self.forces(&[displacement, 0.0])[0].abs()
        }
    }
}

/// Error bound of a work, relative to the integral of magnitudes and in units of the orbit's relative error: works that are zero were at most
/// a quarter of one in 624 orbits (`forces_without_work_have_none_within_what_is_stated`), with room for orbits near a separatrix.
const ROUNDINGS: f64 = 8.0;

/// Integrates over each half of an orbit, on which the velocity has one sign.
fn over_halves(orbit: &Orbit, of: &dyn Fn(&[f64]) -> f64) -> Integral {
    let half = 0.5 * orbit.period();
    let halves = [0.0, half].map(|begin| gauss_kronrod(|part| of(&orbit.state_at(begin + half * part))));
    Integral {
        value: half * (halves[0].value + halves[1].value),
        error: half * (halves[0].error + halves[1].error),
    }
}
