//! Formulas whose numbers double precision does not hold.

use super::{Jet, Tape};
use crate::algebra::{BigFloat, Doubles, Floats};

/// Bits in which it is seen whether a formula has a value.
const PRECISION: usize = 128;

impl Tape {
    /// Returns whether some part of the formulas is beyond the range of double precision where all of them have values.
    #[doc(hidden)]
    pub fn overflows_at(&self, inputs: &[f64]) -> bool {
        let doubles = Jet::new(&Doubles, self, inputs);
        let is_finite = doubles.is_ok_and(|jet| jet.values().all(|value| value.is_finite()));
        !is_finite && self.has_values_at(inputs)
    }

    /// Returns whether the formulas have values in numbers of any size.
    fn has_values_at(&self, inputs: &[f64]) -> bool {
        let inputs: Option<Vec<BigFloat>> =
            inputs.iter().map(|input| BigFloat::from_f64(*input, PRECISION)).collect();
        inputs.is_some_and(|inputs| Jet::new(&Floats { precision: PRECISION }, self, &inputs).is_ok())
    }
}
