//! The named systems with their descriptions and sources. Attributions from memory are marked as such.

mod conservative;
mod coupled;
mod driven;
mod first_order;
mod free;

use super::named::{NamedBody, NamedCoordinate, NamedSystem};
use libration_numbers::{
    catalogue::{NamedParameter, UnknownKey},
    internals::catalogue::by_key,
};

/// Every named system.
pub fn catalogue() -> impl Iterator<Item = &'static NamedSystem> + Clone {
    let pendulums = free::SYSTEMS.iter().chain(driven::SYSTEMS).chain(coupled::SYSTEMS);
    pendulums.chain(conservative::SYSTEMS).chain(first_order::SYSTEMS)
}

/// The defaults of an entry's fields.
const NOTHING_SAID: NamedSystem = NamedSystem {
    key: "",
    also: &[],
    title: "",
    equations: "",
    coordinates: &[],
    parameters: &[],
    energy: "",
    energy_unit: "",
    power: "",
    drive_frequency: None,
    count: None,
    velocity_power: None,
    bodies: &[],
    description: "",
    domain: "",
    source: "",
};

const fn parameter(
    name: &'static str,
    default: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> NamedParameter {
    NamedParameter { name, default, unit, meaning }
}

const OMEGA0: NamedParameter =
    parameter("omega0", "1", "rad/s", "angular frequency of small swings, sqrt(g/l)");
const GRAVITY: NamedParameter = parameter("g", "1", "m/s^2", "acceleration of gravity");

/// The angle of a single pendulum.
const THETA: &[NamedCoordinate] = &[angle("theta")];

/// An angle from the downward vertical.
const fn angle(name: &'static str) -> NamedCoordinate {
    NamedCoordinate { name, unit: "rad", at_rest: "0" }
}

/// A coordinate without a unit.
const fn number(name: &'static str, at_rest: &'static str) -> NamedCoordinate {
    NamedCoordinate { name, unit: "", at_rest }
}

/// A single pendulum on a fixed axle.
const HANGING: &[NamedBody] = &[NamedBody { place: ["sin(theta)", "-cos(theta)"], pivot: ["0", "0"] }];

/// The energy of a single pendulum divided by its moment of inertia, zero at rest at the bottom.
const SWING_ENERGY: &str = "theta'^2/2 + 2*omega0^2*sin(theta/2)^2";

impl NamedSystem {
    /// The system of this key.
    ///
    /// # Errors
    /// No system has this key; the error lists the nearest keys and all keys.
    pub fn by_key(key: &str) -> Result<&'static Self, UnknownKey> {
        by_key(catalogue(), key)
    }
}
