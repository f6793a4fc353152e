//! The Taylor series of a formula about a place.

use super::{Expression, Jet, Symbol, Tape};
use crate::algebra::Ring;

impl Expression {
    /// The first coefficients of the formula's power series in the distance of a variable from a place, over any ring; `None`
    /// where the formula holds other letters, is not analytic at the place, or has no coefficients in the ring.
    ///
    /// ```
    /// # extern crate libration_numbers as libration;
    /// use libration::algebra::{Rational, Rationals};
    /// use libration::expression::{Expression, Symbol};
    ///
    /// let force: Expression = "x/(1 - x)".parse()?;
    /// let series = force.taylor_series(&Rationals, &Symbol::plain("x"), &Rational::from(2), 4).ok_or("no series")?;
    /// assert_eq!(series.iter().map(ToString::to_string).collect::<Vec<_>>(), ["-2", "1", "-1", "1"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn taylor_series<R: Ring>(
        &self,
        ring: &R,
        variable: &Symbol,
        place: &R::Element,
        length: usize,
    ) -> Option<Vec<R::Element>> {
        let tape = Tape::new(&[self], std::slice::from_ref(variable)).ok()?;
        let mut jet = Jet::new(ring, &tape, std::slice::from_ref(place)).ok()?;
        let one = ring.rational(&1.into())?;
        for n in 1..length {
            jet.extend(&[if n == 1 { one.clone() } else { ring.zero() }]).ok()?;
        }
        Some(jet.result(0)[..length.min(jet.result(0).len())].to_vec())
    }
}
