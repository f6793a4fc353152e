//! A number with its uncertainty.

use std::fmt;

use libration::quantity::{Quantity, with_uncertainty};

/// A value with its standard uncertainty, both in one unit.
///
/// # Examples
/// ```
/// use libration_lab::fit::Uncertain;
/// let t0 = Uncertain { value: 2.00641, uncertainty: 0.00023 };
/// assert_eq!(t0.to_string(), "2.00641 ± 0.00023");
/// assert!((t0.deviation_from(2.0) - 27.87).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Uncertain {
    /// The estimate.
    pub value: f64,
    /// One standard deviation.
    pub uncertainty: f64,
}

impl Uncertain {
    /// Distance from a number, in standard uncertainties.
    #[must_use]
    pub fn deviation_from(self, other: f64) -> f64 {
        (self.value - other).abs() / self.uncertainty
    }

    /// The uncertainty relative to the value.
    #[must_use]
    pub fn relative(self) -> f64 {
        self.uncertainty / self.value.abs()
    }

    /// Adds an independent error of this standard deviation.
    #[must_use]
    pub fn with_error(self, deviation: f64) -> Self {
        Self { uncertainty: libm::hypot(self.uncertainty, deviation), ..self }
    }
}

/// `1.637 ± 0.002`, to two digits of the uncertainty.
impl fmt::Display for Uncertain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&with_uncertainty(self.value, self.uncertainty, ""))
    }
}

impl From<Uncertain> for Quantity {
    fn from(Uncertain { value, uncertainty }: Uncertain) -> Self {
        Self { value, uncertainty: Some(uncertainty) }
    }
}
