//! The divergence of the flow of one coordinate: the growth rate of volumes of deviations.

use super::path::Path;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};

/// The divergence ∂F/∂x′ of one autonomous coordinate, the rate at which the volume of deviations grows.
#[derive(Debug)]
pub(super) struct Divergence {
    of_state: Tape,
}

impl Divergence {
    /// The divergence; `None` for several coordinates, or a derivative without values.
    pub(super) fn new(equation: &Equation) -> Option<Self> {
        let [variable] = equation.variables() else { return None };
        equation.refuse_first_order().ok()?;
        let x = Symbol::plain(variable);
        let velocity = x.with_primes(1);
        let slope = equation.accelerations()[0].derivative(&velocity).simplified();
        Some(Self { of_state: Tape::new(&[&slope], &[x, velocity]).ok()? })
    }

    /// The integral of the divergence along a motion.
    pub(super) fn along(&self, path: &Path) -> f64 {
        path.integral(|state| {
            Jet::new(&Doubles, &self.of_state, state).map_or(f64::NAN, |jet| jet.result(0)[0])
        })
    }
}
