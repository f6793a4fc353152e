//! Small oscillations of systems about an equilibrium, and the change of their frequencies with the amplitude.
//!
//! About an equilibrium, x″ = −A·x + G·x′. If the entries are rational, the frequencies are roots of an
//! exact polynomial, written with square roots if its factors allow it. The next terms of the forces
//! change the frequency of a mode by κa²: Lindstedt's expansion in several coordinates, to third order.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::normal_modes::NormalModes;
//!
//! // Two equal masses between walls, on three equal springs: in phase with frequency 1, in opposite phase with √3.
//! let modes = NormalModes::new(&"x'' = y - 2*x; y'' = x - 2*y".parse()?)?.modes;
//! let exact: Vec<String> =
//!     modes.iter().filter_map(|mode| mode.frequency_squared.as_ref()).map(|square| square.square_root_text()).collect();
//! assert_eq!(exact, ["1", "sqrt(3)"]);
//! assert_eq!((modes[1].shape[0].re, modes[1].shape[1].re), (1.0, -1.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! The characteristic polynomial of exact entries is exact; approximate roots only suggest factors, which must divide it.
//! Lindstedt's expansion to third order uses a tower of at most two square roots, so that κ/ω of the double pendulum is a
//! number with √2, or `f64`s if nothing is known exactly. The matrix of the first harmonic is singular: two additional
//! unknowns, the frequency and the growth, and two conditions on the leading coordinate make the system regular.

mod error;
mod mode;
mod equilibrium;
mod linearisation;

#[doc(hidden)]
pub(crate) mod roots;
mod spectrum;
mod shapes;
mod lindstedt;
mod no_shift;
mod resonance;
mod shift;
mod modes;

pub use error::{ModesError, Position, SearchEnd};
pub use mode::{Behaviour, Mode, Resonance, Shift};
pub use modes::NormalModes;
pub use no_shift::ShiftError;
