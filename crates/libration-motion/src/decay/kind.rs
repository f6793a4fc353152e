//! The named kinds of damping.

use super::PowerLawTerm;

/// A named kind of damping.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DampingKind {
    /// Dry friction: d·sign θ′, with d in rad/s².
    Dry,
    /// Drag by a viscous fluid: b·θ′, with b in 1/s.
    Linear,
    /// Drag by a turbulent fluid: c·θ′·|θ′|, with dimensionless c.
    Quadratic,
}

impl DampingKind {
    /// All kinds, by the power of the velocity.
    pub const ALL: [Self; 3] = [Self::Dry, Self::Linear, Self::Quadratic];

    /// `dry`, `linear`, `quadratic`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Dry => "dry",
            Self::Linear => "linear",
            Self::Quadratic => "quadratic",
        }
    }

    /// The exponent of the velocity, as in [`PowerLawTerm`].
    #[must_use]
    pub fn exponent(self) -> f64 {
        match self {
            Self::Dry => 0.0,
            Self::Linear => 1.0,
            Self::Quadratic => 2.0,
        }
    }

    /// The damping term with a coefficient, in the unit of this kind.
    #[must_use]
    pub fn term(self, coefficient: f64) -> PowerLawTerm {
        PowerLawTerm { exponent: self.exponent(), coefficient }
    }

    /// The unit of the coefficient; `1` if it is dimensionless.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Dry => "rad/s^2",
            Self::Linear => "1/s",
            Self::Quadratic => "1",
        }
    }
}
