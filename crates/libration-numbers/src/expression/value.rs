//! Constants as numbers.

use super::{Expression, Jet, Tape};
use crate::algebra::Doubles;

impl Expression {
    /// The value of a formula without symbols; NaN or infinite if it is undefined. `None` if the formula contains symbols.
    ///
    /// # Accuracy
    /// Rational parts are computed exactly and rounded once; every other operation is rounded.
    #[must_use]
    pub fn to_f64(&self) -> Option<f64> {
        let tape = Tape::new(&[self], &[]).ok()?;
        let jet = Jet::new(&Doubles, &tape, &[]).ok()?;
        Some(jet.result(0)[0])
    }
}
