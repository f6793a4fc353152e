//! Constants as numbers.

use super::{Expression, Jet, Tape};
use crate::algebra::Doubles;

impl Expression {
    /// The value of a formula without symbols; NaN or infinite where it has none. `None` when there are symbols in it.
    ///
    /// # Accuracy
    /// Fractions are worked out exactly and rounded once; each other operation is rounded.
    #[must_use]
    pub fn to_f64(&self) -> Option<f64> {
        let tape = Tape::new(&[self], &[]).ok()?;
        let jet = Jet::new(&Doubles, &tape, &[]).ok()?;
        Some(jet.result(0)[0])
    }
}
