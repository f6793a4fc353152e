//! The coordinates of a model with their units.

/// A coordinate of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    /// Its name in the equations: `theta`.
    pub name: String,
    /// Its unit: `rad` for an angle, empty where an equation that was typed does not tell.
    pub unit: String,
    /// Where it is at rest; zero where no such place is known.
    pub rest: f64,
}

/// Names that are those of angles, with or without a number behind them.
const ANGLES: [&str; 8] = ["theta", "vartheta", "phi", "varphi", "psi", "alpha", "beta", "gamma"];

impl Coordinate {
    /// A coordinate of which only the name is known: with a Greek letter that is used for angles it is one.
    pub(super) fn by_name(name: &str) -> Self {
        let letter = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_');
        let unit = if ANGLES.contains(&letter) { "rad" } else { "" };
        Self { name: name.to_owned(), unit: unit.to_owned(), rest: 0.0 }
    }

    /// Whether it is an angle, in radians.
    #[must_use]
    pub fn is_angle(&self) -> bool {
        self.unit == "rad"
    }

    /// The unit of its velocity, with times in seconds; empty where its own is not known.
    #[must_use]
    pub fn velocity_unit(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!("{}/s", self.unit) }
    }
}
