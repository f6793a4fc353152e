//! Loss of the complement when an angle is rounded to a double.

use std::fmt;

use super::Angle;

/// An angle so near the upright position that rounding changes its complement noticeably. The complement decides how long a pendulum stays near
/// the top: an integration from the nearest double belongs to another start.
///
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::RoundedComplement;
/// let lost = RoundedComplement::of(&"pi-1e-20".parse()?).unwrap();
/// assert_eq!((lost.wanted, lost.rounded), (1e-20, 1.2246467991473532e-16));
/// assert_eq!(RoundedComplement::of(&"179.9deg".parse()?), None);
/// # Ok::<(), libration::quantity::QuantityError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedComplement {
    /// The complement of the angle, in radians.
    pub wanted: f64,
    /// The complement of the nearest double.
    pub rounded: f64,
}

impl RoundedComplement {
    /// The effect of rounding on an angle, including the upright position; `None` if the complement keeps twelve digits, as it does below
    /// 179.98°. The period depends on the logarithm of the complement, so that its error is smaller still.
    #[must_use]
    pub fn of(angle: &Angle) -> Option<Self> {
        /// Relative error of a complement with twelve digits.
        const KEPT: f64 = 1e-12;
        let wanted = angle.complement();
        let rounded = Angle::from_radians(angle.radians()).ok()?.complement();
        let is_lost = (rounded - wanted).abs() > KEPT * wanted;
        is_lost.then_some(Self { wanted, rounded })
    }
}

impl fmt::Display for RoundedComplement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { wanted, rounded } = self;
        match *wanted {
            0.0 => write!(f, "the upright position becomes {rounded:.5e} rad from it")?,
            _ => write!(f, "{wanted:e} rad from the upright position becomes {rounded:.5e} rad")?,
        }
        write!(
            f,
            " in the state that is integrated, the nearest double: all results \
             are for the motion from there; for a free pendulum, `motion` and `period` keep the distance"
        )
    }
}
