//! Systems to be simulated: named systems with their energies, units and
//! sources, oscillators of the other catalogue, and equations given as text.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::systems::Model;
//! use libration::taylor::Moment;
//!
//! // The positions of the bodies of a double pendulum, and its energy, which the motion conserves.
//! let model = Model::by_key("double_pendulum", &[], &[])?;
//! let start = Moment { time: 0.0, state: vec![std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0] };
//! let bodies = model.bodies().ok_or("no places")?.at(&start);
//! assert_eq!(bodies.len(), 2);
//! assert_eq!(model.energy()?.balance(&start).drift(), 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod catalogue;
mod named;
mod coordinate;
mod count;
mod error;
mod idle_drive;
mod initial;
mod model;
mod bodies;
mod energy;
mod line_integral;
mod observables;
mod zero;

pub use bodies::{Bodies, Body};
pub use catalogue::catalogue;
pub use coordinate::Coordinate;
pub use energy::{Energy, EnergyAccount, EnergyBalance};
pub use error::{EnergyError, ModelError};
pub use initial::{InitialState, InitialStateError};
pub use model::Model;
pub use named::{NamedBody, NamedCoordinate, NamedSystem, PendulumParametersError, VelocityPower};
pub use observables::{ObservableError, Observables};
pub use zero::{ConditionError, condition};
