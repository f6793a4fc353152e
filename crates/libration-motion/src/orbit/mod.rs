//! Periodic orbits of any equations of motion, found by integration in time.
//!
//! The motion of one coordinate released from rest is followed until it comes to rest again. Limit
//! cycles, responses to a periodic force, and orbits of several coordinates are closed by Newton's
//! method, with derivatives from the variational equations; these also give the Floquet multipliers.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::orbit::Orbit;
//! use libration::progress::Quiet;
//!
//! // The pendulum from 60°, integrated by this module and compared with its closed form.
//! let orbit = Orbit::released(&"theta'' + sin(theta) = 0".parse()?, std::f64::consts::FRAC_PI_3, &Quiet)?;
//! let exact = libration::pendulum::Pendulum::from_angular_frequency(1.0)?.released_from("60deg".parse()?)?.period();
//! assert!((orbit.period() - exact).abs() <= orbit.period_uncertainty());
//!
//! // Van der Pol's limit cycle, from a start inside it, with its Floquet multipliers.
//! let cycle = Orbit::limit_cycle(&"x'' - (1 - x^2) x' + x = 0".parse()?, &[0.5, 0.0], &Quiet)?;
//! assert!((cycle.period() - 6.6632868593231301896996820).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod path;
mod pieces;
mod harmonics;
#[doc(hidden)]
pub(crate) mod least_period;
mod near;
mod periodic;
mod divergence;

#[doc(hidden)]
pub(crate) mod acceleration;
#[doc(hidden)]
pub(crate) mod release_place;
#[doc(hidden)]
pub(crate) mod precise;
#[doc(hidden)]
pub(crate) mod released;
mod closing;
mod shooting;
mod drift;
mod family;
mod relaxation;
mod cycle;
mod driven;
mod search;

pub use crate::periodic::{Floquet, Stability};
pub use error::{Lost, OrbitError};
pub use harmonics::{Harmonic, Harmonics};
pub use near::OrbitGuess;
pub use periodic::Orbit;
pub use search::{OrbitKind, OrbitSearch};
