//! Oscillators: an equation of motion about an equilibrium, and a catalogue of named ones.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::oscillator::{NamedOscillator, Oscillator};
//!
//! // A charge between two others: the equilibrium is exact if it is a rational number.
//! let typed = Oscillator::new(&"x'' = 1/x^2 - 1/(3 - x)^2".parse()?)?;
//! assert_eq!((typed.equilibrium().to_string(), typed.omega0_squared().to_string()), ("1.5".into(), "32/27".into()));
//!
//! let named = NamedOscillator::by_key("pendulum")?.oscillator(&[])?;
//! assert!(named.is_odd());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod catalogue;
mod named;
mod centre;
mod constant;
mod equilibrium;
mod force;
mod neighbourhood;
#[doc(hidden)]
pub(crate) mod roots;
mod sides;
mod error;
mod model;
mod named_constants;
mod numbers_or_letters;
mod pure_power;
mod remedy;
mod symbolic;

pub use catalogue::catalogue;
pub use centre::centre_of;
pub use constant::{Approximation, Constant};
pub use error::{FrequencySource, OscillatorError, RejectedEquilibrium, RejectionReason};
pub use model::{Kind, Oscillator};
pub use named::NamedOscillator;
pub use neighbourhood::{Roughness, Tendency};
pub use numbers_or_letters::{NumbersOrLetters, NumbersOrLettersError};
pub use pure_power::PurePower;
pub use remedy::Remedy;
pub use symbolic::{SymbolicOscillator, SymbolicOscillatorError, SymbolicSeriesError};
