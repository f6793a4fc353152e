//! Formulas whose values exceed the range of double precision.

use super::{Jet, Tape};
use crate::algebra::{BigFloat, Doubles, Floats};

/// Precision, in bits, in which it is decided whether a formula has a value.
const PRECISION: usize = 128;

impl Tape {
    /// Returns `true` if some part of the formulas is beyond the range of double precision although all of them have values.
    #[doc(hidden)]
    pub fn overflows_at(&self, inputs: &[f64]) -> bool {
        let doubles = Jet::new(&Doubles, self, inputs);
        let is_finite = doubles.is_ok_and(|jet| jet.values().all(|value| value.is_finite()));
        !is_finite && self.has_values_at(inputs)
    }

    /// Returns `true` if the formulas have values, in numbers of any size.
    fn has_values_at(&self, inputs: &[f64]) -> bool {
        let inputs: Option<Vec<BigFloat>> =
            inputs.iter().map(|input| BigFloat::from_f64(*input, PRECISION)).collect();
        inputs.is_some_and(|inputs| Jet::new(&Floats { precision: PRECISION }, self, &inputs).is_ok())
    }
}
