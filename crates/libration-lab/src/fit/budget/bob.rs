//! Bobs of several shapes: moment of inertia, volume and reach.
//!
//! The axis of a disc or ring is parallel to that about which the pendulum turns, so that it swings in its own plane; the axis of a cylinder or cap
//! is along the rod. κ is the moment of inertia about the horizontal axis through the centre of mass, over the mass.

use super::BudgetError;
use libration::quantity::Quantity;
use std::f64::consts::PI;

/// Shape of a bob of uniform density.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BobShape {
    /// A ball: κ = 2r²/5.
    #[default]
    Ball,
    /// A disc that swings in its own plane: κ = r²/2.
    Disc,
    /// A cylinder with its axis along the rod: κ = r²/4 + h²/12.
    Cylinder,
    /// A disc with a hole of radius i at its centre: κ = (r² + i²)/2.
    Ring,
    /// A cap of height h cut from a ball of radius r, with its axis along the rod.
    Cap,
    /// Any shape with the radius of gyration r, the root of its moment of inertia over its mass: κ = r².
    Gyration,
}

impl BobShape {
    /// All shapes.
    pub const ALL: [Self; 6] =
        [Self::Ball, Self::Disc, Self::Cylinder, Self::Ring, Self::Cap, Self::Gyration];

    /// Name of the shape: `ball`, `disc`, `cylinder`, `ring`, `cap`, `gyration`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ball => "ball",
            Self::Disc => "disc",
            Self::Cylinder => "cylinder",
            Self::Ring => "ring",
            Self::Cap => "cap",
            Self::Gyration => "gyration",
        }
    }

    /// Returns `true` if the moment of inertia depends on the height.
    #[must_use]
    pub fn needs_height(self) -> bool {
        matches!(self, Self::Cylinder | Self::Cap)
    }

    /// Returns `true` if the shape has a height or thickness.
    #[must_use]
    pub fn has_height(self) -> bool {
        !matches!(self, Self::Ball | Self::Gyration)
    }
}

/// A bob. Lengths are metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bob {
    /// The shape.
    pub shape: BobShape,
    /// Radius of the ball, disc, cylinder or ring, of the ball that a cap is cut from, or of gyration.
    pub radius: Quantity,
    /// Height of a cylinder or cap, thickness of a disc or ring, with which the density follows from the mass.
    pub height: Option<Quantity>,
    /// Radius of the hole of a ring.
    pub inner_radius: Option<Quantity>,
}

impl Bob {
    /// A ball of this radius.
    #[must_use]
    pub fn ball(radius: Quantity) -> Self {
        Self { shape: BobShape::Ball, radius, height: None, inner_radius: None }
    }

    /// Radius of the circle as which the bob is seen along the axis about which the pendulum turns; `None` for other outlines.
    #[must_use]
    pub fn outline_radius(&self) -> Option<Quantity> {
        matches!(self.shape, BobShape::Ball | BobShape::Disc | BobShape::Ring).then_some(self.radius)
    }

    /// κ, the moment of inertia over the mass, in m².
    #[must_use]
    pub fn gyration(&self) -> f64 {
        self.size().gyration()
    }

    /// Radius of a ball with the same κ, in m.
    #[must_use]
    pub fn radius_of_ball(&self) -> f64 {
        self.size().radius_of_ball()
    }

    /// Refuses impossible sizes.
    ///
    /// # Errors
    /// A cylinder or cap without height, a cap higher than its ball, a ring whose hole is not smaller than itself.
    pub fn check(&self) -> Result<(), BudgetError> {
        let Size { shape, radius, height, inner } = self.size();
        let reason = match shape {
            BobShape::Cylinder | BobShape::Cap if height <= 0.0 => "it needs a height above zero",
            BobShape::Cap if height > 2.0 * radius => {
                "it is higher than the ball of this radius from which it is cut"
            }
            BobShape::Ring if inner >= radius => "its hole is not smaller than the ring",
            _ => return Ok(()),
        };
        Err(BudgetError::Bob { shape: shape.name(), reason })
    }

    /// The lengths without their uncertainties.
    pub(super) fn size(&self) -> Size {
        let value = |length: Option<Quantity>| length.map_or(0.0, |length| length.value);
        Size {
            shape: self.shape,
            radius: self.radius.value,
            height: value(self.height),
            inner: value(self.inner_radius),
        }
    }
}

/// Shape and lengths of a bob, zero where they are not known.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::fit) struct Size {
    pub(in crate::fit) shape: BobShape,
    pub(in crate::fit) radius: f64,
    pub(in crate::fit) height: f64,
    pub(in crate::fit) inner: f64,
}

impl Size {
    /// κ.
    pub(in crate::fit) fn gyration(self) -> f64 {
        let Self { shape, radius, height, inner } = self;
        match shape {
            BobShape::Ball => 0.4 * radius * radius,
            BobShape::Disc => 0.5 * radius * radius,
            BobShape::Cylinder => 0.25 * radius * radius + height * height / 12.0,
            BobShape::Ring => 0.5 * (radius * radius + inner * inner),
            BobShape::Cap => gyration_of_cap(radius, height),
            BobShape::Gyration => radius * radius,
        }
    }

    /// Radius of a ball with the same κ.
    pub(in crate::fit) fn radius_of_ball(self) -> f64 {
        if self.shape == BobShape::Ball { self.radius } else { (2.5 * self.gyration()).sqrt() }
    }

    /// Volume in m³; zero where it is not known.
    pub(super) fn volume(self) -> f64 {
        let Self { shape, radius, height, inner } = self;
        match shape {
            BobShape::Ball => 4.0 / 3.0 * PI * radius * radius * radius,
            BobShape::Disc | BobShape::Cylinder => PI * radius * radius * height,
            BobShape::Ring => PI * (radius * radius - inner * inner) * height,
            BobShape::Cap => PI * height * height * (3.0 * radius - height) / 3.0,
            BobShape::Gyration => 0.0,
        }
    }

    /// Distance from the centre to the surface towards the pivot; half of the height for a cap, whichever way up.
    pub(super) fn reach(self) -> f64 {
        match self.shape {
            BobShape::Ball | BobShape::Disc | BobShape::Ring => self.radius,
            BobShape::Cylinder | BobShape::Cap => 0.5 * self.height,
            BobShape::Gyration => 0.0,
        }
    }
}

/// κ of a cap of height h cut from a ball of radius r. With x = h/r the volume over πr³, the static moment about the centre of the ball over πr⁴, and
/// the moments of inertia over πr⁵ are integrals of powers of z over 1 − x < z < 1.
fn gyration_of_cap(radius: f64, height: f64) -> f64 {
    if radius <= 0.0 {
        return 0.0;
    }
    let x = height / radius;
    let volume = x * x * (1.0 - x / 3.0);
    let statical = 0.25 * x * x * (2.0 - x) * (2.0 - x);
    let polar = x * x * x * (2.0 / 3.0 - 0.5 * x + 0.1 * x * x);
    // ∫z²(1 − z²)dz from 1 − x to 1.
    let along = x * x * (1.0 - 5.0 / 3.0 * x + x * x - 0.2 * x * x * x);
    let centre = statical / volume;
    radius * radius * ((0.5 * polar + along) / volume - centre * centre)
}
