//! A position as exactly as it is known.

use libration_numbers::algebra::{BigFloat, Rational};
use libration_numbers::quantity::Displacement;

/// The starting position of a motion: a displacement from an origin, both held exactly as given.
#[derive(Clone, Debug)]
pub struct ReleasePlace {
    origin: BigFloat,
    displacement: Displacement,
}

impl ReleasePlace {
    pub fn new(origin: BigFloat, displacement: Displacement) -> Self {
        Self { origin, displacement }
    }

    /// Exactly this `f64`; `None` if it is not finite.
    pub(crate) fn from_f64(position: f64) -> Option<Self> {
        let displacement = Displacement::from_f64(position)?;
        Some(Self { origin: BigFloat::from_integer(0, 1), displacement })
    }

    /// The position rounded to `precision` bits.
    pub(super) fn to_bits(&self, precision: usize) -> BigFloat {
        // An equilibrium may be subtracted from it again.
        let wide = 2 * precision;
        let [multiple, rest] = self.displacement.fractions();
        let [multiple, rest] = [multiple, rest].map(|(n, d)| Rational::from_parts(n, d));
        let turned = BigFloat::from_rational(&multiple, wide) * BigFloat::pi(wide);
        let sum = turned + BigFloat::from_rational(&rest, wide) + self.origin.rounded_to(wide);
        sum.rounded_to(precision)
    }

    /// The nearest `f64`, up to a double rounding.
    pub(super) fn to_f64(&self) -> f64 {
        const PRECISION: usize = 128;
        self.to_bits(PRECISION).to_f64()
    }
}
