//! Exact displacements: decimals and combinations with π, without rounding.

use std::fmt;

use dashu_int::{IBig, UBig};

use super::angle_text::exact_angle;
use super::decimal::Decimal;
use super::excerpt::excerpt;
use super::pi_combination::PiCombination;
use super::{Angle, Dimension, QuantityError};

/// A displacement a·π + b with fractions a and b: the exact decimal of a text, not the nearest `f64`.
///
/// Next to a separatrix, digits of the period depend on the difference between the two.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::Displacement;
/// let nearly_upright = Displacement::from_angle_text("pi-1e-12")?;
/// assert_eq!(nearly_upright.to_angle().map(|angle| angle.complement()), Some(1e-12));
/// assert_ne!(Displacement::from_number_text("0.1")?, Displacement::from_f64(0.1).ok_or("finite")?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Displacement(pub(super) PiCombination);

impl Displacement {
    /// Exactly this `f64`; `None` if it is not finite.
    #[must_use]
    pub fn from_f64(value: f64) -> Option<Self> {
        value.is_finite().then(|| Self(PiCombination::radians(value)))
    }

    /// The exact decimal number of a text.
    ///
    /// # Errors
    /// Text that is not a decimal number, or a number beyond the range of `f64`.
    pub fn from_number_text(text: &str) -> Result<Self, QuantityError> {
        let unsigned = text.trim();
        let number = Decimal::parse(unsigned.strip_prefix('+').unwrap_or(unsigned));
        let number = number.ok_or_else(|| QuantityError::UnreadableQuantity {
            text: excerpt(text),
            // A displacement has the unit of the equation of motion.
            dimension: Dimension::Length,
        })?;
        Ok(Self(PiCombination { pi_multiple: dashu_ratio::RBig::ZERO, rest: number.exact() }))
    }

    /// The exact angle of a text; a bare number is a decimal number of radians.
    ///
    /// # Errors
    /// As for an [`Angle`].
    pub fn from_angle_text(text: &str) -> Result<Self, QuantityError> {
        exact_angle(text).map(Self)
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.0.nearest().unwrap_or(f64::INFINITY)
    }

    /// Number of degrees if the angle is a rational multiple of π, as from text in degrees; `None` for other angles and for zero.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_numbers as libration;
    /// use libration::quantity::Displacement;
    /// assert_eq!(Displacement::from_angle_text("37.3deg")?.degrees(), Some(37.3));
    /// assert_eq!(Displacement::from_angle_text("pi/3")?.degrees(), Some(60.0));
    /// assert_eq!(Displacement::from_angle_text("1.2rad")?.degrees(), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn degrees(&self) -> Option<f64> {
        let PiCombination { pi_multiple, rest } = &self.0;
        let is_multiple = rest.is_zero() && !pi_multiple.is_zero();
        is_multiple.then(|| (pi_multiple * dashu_ratio::RBig::from(180)).to_f64().value())
    }

    /// The displacement as an angle with its complement, each in two words; `None` if its turns cannot be counted.
    #[must_use]
    pub fn to_angle(&self) -> Option<Angle> {
        Angle::from_radians(self.to_f64()).ok().map(|_| self.0.to_angle())
    }

    /// Numerator and denominator, if the displacement does not contain π.
    #[doc(hidden)]
    pub fn fraction(&self) -> Option<(IBig, UBig)> {
        let [(multiple, _), rest] = self.fractions();
        (multiple == IBig::ZERO).then_some(rest)
    }

    /// Numerators and denominators of a and b.
    #[doc(hidden)]
    pub fn fractions(&self) -> [(IBig, UBig); 2] {
        [&self.0.pi_multiple, &self.0.rest].map(|part| (part.numerator().clone(), part.denominator().clone()))
    }
}

/// The nearest `f64`, in the shortest form that is read as the same number.
impl fmt::Display for Displacement {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", self.to_f64())
    }
}
