//! The coordinates of a model with their units.

use libration_numbers::quantity::is_angle_name;

/// A coordinate of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    /// The name in the equations: `theta`.
    pub name: String,
    /// The unit: `rad` for an angle, empty if an equation given as text does not determine it.
    pub unit: String,
    /// The value at rest; zero if none is known.
    pub at_rest: f64,
}

impl Coordinate {
    /// A coordinate of which only the name is known.
    pub(super) fn by_name(name: &str) -> Self {
        let unit = if is_angle_name(name) { "rad" } else { "" };
        Self { name: name.to_owned(), unit: unit.to_owned(), at_rest: 0.0 }
    }

    /// Returns `true` if the coordinate is an angle, in radians.
    #[must_use]
    pub fn is_angle(&self) -> bool {
        self.unit == "rad"
    }

    /// The unit of the velocity, with times in seconds; empty if the unit of the coordinate is not known.
    pub(super) fn velocity_unit(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!("{}/s", self.unit) }
    }
}
