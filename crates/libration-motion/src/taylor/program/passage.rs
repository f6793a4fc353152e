//! Equations of motion at points at which they have values but no series: |x|^1.5 and the like at zero.

use super::moduli::Modulus;
use crate::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Expression, Symbol, WithoutValue},
    internals::expression::{Jet, Tape},
};

/// The equations with their |…| in the original form, the arguments of these, and the formulas of events.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Passage {
    tape: Tape,
    coordinates: usize,
    moduli: usize,
    /// The indices of the |…| of which a power without a series is taken, and with which no divisor vanishes.
    roots: Vec<usize>,
    /// The state components of which such a power is taken directly.
    bases: Vec<usize>,
}

/// The values of these formulas in a state.
pub(in crate::taylor) struct Values {
    values: Vec<f64>,
    coordinates: usize,
    moduli: usize,
}

impl Passage {
    /// The passage; `None` if there is no such power.
    pub(in crate::taylor) fn new(
        derivatives: &[Expression],
        moduli: &[Modulus],
        bases: Vec<usize>,
        events: &[Expression],
        inputs: &[Symbol],
    ) -> Result<Option<Self>, WithoutValue> {
        let is_passed = |number: &usize| moduli[*number].in_root && !moduli[*number].divides;
        let roots: Vec<usize> = (0..moduli.len()).filter(is_passed).collect();
        if roots.is_empty() && bases.is_empty() {
            return Ok(None);
        }
        let written = moduli.iter().map(|modulus| &modulus.written);
        let formulas: Vec<&Expression> = derivatives.iter().chain(written).chain(events).collect();
        let tape = Tape::new(&formulas, inputs)?;
        Ok(Some(Self { tape, coordinates: derivatives.len(), moduli: moduli.len(), roots, bases }))
    }

    pub(in crate::taylor) fn roots(&self) -> &[usize] {
        &self.roots
    }

    pub(in crate::taylor) fn bases(&self) -> &[usize] {
        &self.bases
    }

    /// The values of the formulas; `None` if one has no value.
    pub(in crate::taylor) fn at(&self, time: f64, state: &[f64], parameters: &[f64]) -> Option<Values> {
        let inputs = [state, &[time], parameters].concat();
        let jet = Jet::new(&Doubles, &self.tape, &inputs).ok()?;
        let formulas = 0..self.tape.results().len();
        let values: Vec<f64> = formulas.map(|formula| jet.result(formula)[0]).collect();
        let is_finite = values[..self.coordinates].iter().all(|value| value.is_finite());
        let (coordinates, moduli) = (self.coordinates, self.moduli);
        is_finite.then_some(Values { values, coordinates, moduli })
    }
}

impl Values {
    /// The rate of change of each state component.
    pub(in crate::taylor) fn rates(&self, layout: &StateLayout, state: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; state.len()];
        for (coordinate, value) in self.values[..self.coordinates].iter().enumerate() {
            rates[layout.driven(coordinate)] = *value;
            if let Some(velocity) = layout.velocity(coordinate) {
                rates[coordinate] = state[velocity];
            }
        }
        rates
    }

    /// The argument of each |…|.
    pub(in crate::taylor) fn arguments(&self) -> &[f64] {
        &self.values[self.coordinates..][..self.moduli]
    }

    /// The formulas of the events.
    pub(in crate::taylor) fn events(&self) -> &[f64] {
        &self.values[self.coordinates + self.moduli..]
    }
}
