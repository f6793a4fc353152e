//! Continuation of a balanced free oscillation to the response under the full drive and damping.

use super::branch::{FIRST, Limits, Origin, Walk};
use super::corrector::Corrector;
use super::energy_balance::EnergyBalance;
use super::family::{Family, TOLERANCES};
use super::node::Node;
use super::point::BranchPoint;
use super::space::Space;
use libration_motion::orbit::Orbit;
use libration_numbers::algebra::BigFloat;
use libration_numbers::expression::{Equation, Expression};
use libration_numbers::internals::progress::Watch;

/// Initial strengths of drive and damping, in the order of the trials.
const FIRST_STRENGTHS: [f64; 3] = [0.1, 0.02, 0.004];
/// Maximum number of points.
const MOST_POINTS: usize = 300;
/// Largest relative difference in swing between the first driven motion and the free oscillation.
const SAME_SWING: f64 = 0.3;

/// The continuation of the free oscillations of one oscillator to its responses.
pub(super) struct ToFullStrength<'w> {
    equation: Equation,
    strength: String,
    family: Family<'w>,
}

impl<'w> ToFullStrength<'w> {
    pub(super) fn new(balance: &EnergyBalance, watch: &'w Watch<'w>) -> Option<Self> {
        let (equation, strength) = balance.with_part_of_rest();
        let family = Family::new(&equation, &[&strength], &[[FIRST_STRENGTHS[2], 1.0]], watch).ok()?;
        Some(Self { equation, strength, family })
    }

    /// The response into which a free oscillation of some amplitude develops as drive and damping grow together.
    pub(super) fn answer(&self, space: Space, state: &[f64], amplitude: f64) -> Option<BranchPoint> {
        let corrector = Corrector { family: &self.family, space, tolerance: TOLERANCES[0], stale: 1e-12 };
        let mut along = vec![0.0; state.len() + 1];
        along[state.len()] = 1.0;
        let first = |strength: &f64| {
            let unknowns = self.closed(space, state, *strength)?;
            let node = Node::near(&corrector, &unknowns, [&along, &along], 1.0)?;
            ((self.family.largest_swing(&node.point) / amplitude - 1.0).abs() < SAME_SWING).then_some(node)
        };
        let start = FIRST_STRENGTHS.iter().find_map(first)?;
        let limits = Limits {
            range: [0.5 * start.point.parameter, 1.0],
            most_points: MOST_POINTS,
            longest_period: f64::INFINITY,
            largest_growth: f64::INFINITY,
            initial_step: FIRST,
        };
        let branch = Walk::new(corrector, limits, start).walked(Origin::FreeOscillation).branch;
        branch.points.last().filter(|point| point.parameter.to_bits() == 1.0_f64.to_bits()).cloned()
    }

    /// The response near a state at a given strength, followed by the strength.
    fn closed(&self, space: Space, state: &[f64], strength: f64) -> Option<Vec<f64>> {
        let exact = Expression::Number(BigFloat::from_f64(strength, 53)?.to_rational());
        let equation = self.equation.with(&[(&self.strength, exact)]).ok()?;
        let duration = self.family.duration(space, &[], &[strength])?;
        let orbit = Orbit::driven_near(&equation, state, duration, self.family.watch).ok()?;
        Some(orbit.start().into_iter().chain([strength]).collect())
    }
}
