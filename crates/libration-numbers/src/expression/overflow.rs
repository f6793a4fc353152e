//! Formulas whose numbers double precision does not hold.

use super::{Jet, Tape};
use crate::algebra::{BigFloat, Doubles, Floats};

/// Bits in which it is seen whether a formula has a value.
const PRECISION: usize = 128;

impl Tape {
    /// Whether some part of the formulas is beyond the range of double precision where all of them have values.
    #[doc(hidden)]
    pub fn overflows_at(&self, inputs: &[f64]) -> bool {
        let doubles = Jet::new(&Doubles, self, inputs);
        let is_finite = doubles.is_ok_and(|jet| jet.values().all(|value| value.is_finite()));
        !is_finite && self.has_values_at(inputs)
    }

    /// Whether the formulas have values in numbers of any size.
    fn has_values_at(&self, inputs: &[f64]) -> bool {
        let inputs: Option<Vec<BigFloat>> =
            inputs.iter().map(|input| BigFloat::from_f64(*input, PRECISION)).collect();
        inputs.is_some_and(|inputs| Jet::new(&Floats { precision: PRECISION }, self, &inputs).is_ok())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Expression, Symbol};

    #[test]
    fn what_is_too_large_is_told_from_what_has_no_value() {
        let overflows = |text: &str, x: f64| {
            let formula: Expression = text.parse().unwrap();
            Tape::new(&[&formula], &[Symbol::plain("x")]).unwrap().overflows_at(&[x])
        };
        for (text, x) in
            [("cosh(1000*x)", 1.0), ("x/cosh(1000*x)", 1.0), ("x^3", 1e103), ("exp(x)-exp(x)", 710.0)]
        {
            assert!(overflows(text, x), "{text}");
        }
        for (text, x) in [
            ("cosh(700*x)", 1.0),
            ("1/x", 0.0),
            ("ln(x)", -1.0),
            ("x^(3/2)", 0.0),
            ("cosh(1000*x)/(x - 1)", 1.0),
            ("x", f64::INFINITY),
        ] {
            assert!(!overflows(text, x), "{text}");
        }
    }
}
