//! Systems to be simulated: named ones with their energies, units and sources, oscillators of the other catalogue, and
//! equations as they are typed.

mod catalogue;
mod named;

mod coordinate;
mod error;
mod model;

mod bodies;
mod energy;
mod line_integral;

pub use bodies::{Bodies, Body};
pub use catalogue::catalogue;
pub use coordinate::Coordinate;
pub use energy::{Energy, EnergyAccount, EnergyBalance};
pub use error::{ModelError, NoEnergy, UnknownSystem};
pub use model::Model;
pub use named::{NamedBody, NamedCoordinate, NamedSystem, NoSuchPendulum, Parameter};

#[cfg(test)]
mod tests;
