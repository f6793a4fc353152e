//! The Taylor series of a formula about a point.

use super::{Expression, Jet, Symbol, Tape};
use crate::algebra::Ring;

impl Expression {
    /// The first coefficients of the formula's Taylor series in one variable about a point, over any ring; `None` if the formula contains other
    /// symbols, is not analytic at the point, or has coefficients outside the ring.
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
        point: &R::Element,
        length: usize,
    ) -> Option<Vec<R::Element>> {
        let tape = Tape::new(&[self], std::slice::from_ref(variable)).ok()?;
        let mut jet = Jet::new(ring, &tape, std::slice::from_ref(point)).ok()?;
        let one = ring.rational(&1.into())?;
        for n in 1..length {
            jet.extend(&[if n == 1 { one.clone() } else { ring.zero() }]).ok()?;
        }
        Some(jet.result(0)[..length.min(jet.result(0).len())].to_vec())
    }
}
