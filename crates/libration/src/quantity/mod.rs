//! Angles, and physical quantities from text.
//!
//! An [`Angle`] is kept as whole turns, an angle in the turn and its complement to the upright position, each
//! in two words, because near the top π − θ is the number that matters and θ alone has lost it.
//!
//! What text means: radians are the nearest `f64`; degrees, and the δ of `pi-δ`, are the decimal itself,
//! converted exactly and rounded to two words.

mod angle;
mod angle_text;
mod decimal;
mod error;
mod pi_combination;

pub use angle::Angle;
pub use error::QuantityError;

#[cfg(test)]
mod tests;
