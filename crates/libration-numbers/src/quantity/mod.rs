//! Angles, and physical quantities from text.
//!
//! An [`Angle`] consists of whole turns, the angle in the turn and the complement to the upright position, the last two in two words each: near
//! the top results depend on π − θ, which θ alone has lost.
//!
//! Interpretation of text: plain radians are the nearest `f64`; degrees, and the δ of `pi-δ`, are exact decimals, converted exactly and rounded
//! to two words.
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::quantity::{Angle, Dimension, angles, parse};
//!
//! // A nanoradian from the top: the complement is stored, because π − θ in `f64` would lose it.
//! let angle: Angle = "pi-1e-9".parse()?;
//! assert_eq!(angle.complement(), 1e-9);
//! let length = parse("99.4(2) cm", Dimension::Length)?;
//! assert_eq!((length.value, length.uncertainty), (0.994, Some(0.002)));
//! assert_eq!(angles("10deg:170deg:40deg")?.len(), 5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! A decimal is kept as an exact fraction, with its multiple of π separate, until it is rounded once: to two words for an angle, to one word for
//! any other quantity.

mod angle;
mod angle_name;
mod angle_text;
mod bare_radians;
#[doc(hidden)]
pub(crate) mod decimal;
mod digits;
mod dimension;
mod displacement;
mod error;
mod exact_angle;
mod excerpt;
mod fraction;
mod nearest;
mod physical;
#[doc(hidden)]
pub(crate) mod pi_combination;
mod progression;
mod range;
mod range_error;
mod rounded_complement;
mod shortest;
mod unit;

pub use angle::Angle;
pub use angle_name::is_angle_name;
pub use bare_radians::BareRadians;
pub use digits::{rounded, short, to_place, with_uncertainty};
pub use dimension::Dimension;
pub use displacement::Displacement;
pub use error::QuantityError;
pub use excerpt::{alternatives, excerpt, is_bidirectional, printable};
pub(crate) use nearest::nearest;
pub use physical::{Quantity, in_si, parse};
pub use range::{AngleRange, NumberRange, angles, exact_angles, exact_numbers, numbers};
pub use range_error::RangeError;
pub use rounded_complement::RoundedComplement;

/// The standard acceleration of free fall, in m/s² (CGPM 1901).
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::{Dimension, STANDARD_GRAVITY, parse};
/// assert_eq!(parse("1 g", Dimension::Acceleration)?.value, STANDARD_GRAVITY);
/// # Ok::<(), libration::quantity::QuantityError>(())
/// ```
pub const STANDARD_GRAVITY: f64 = 9.80665;
