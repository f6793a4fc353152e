//! Quantities from the command line, each checked with its argument.

use super::bare;
use crate::call;
use libration::quantity::{Angle, Dimension, Displacement, Quantity, QuantityError, parse};

pub(crate) fn angle(text: &str) -> Result<Angle, QuantityError> {
    let angle = text.parse()?;
    bare::say(text);
    Ok(angle)
}

/// An angle as typed.
pub(crate) fn displacement(text: &str) -> Result<Displacement, QuantityError> {
    let displacement = Displacement::from_angle_text(text)?;
    bare::say(text);
    Ok(displacement)
}

/// A length above zero.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    above_zero(text, Dimension::Length)
}

/// A time above zero.
pub(crate) fn time(text: &str) -> Result<f64, String> {
    above_zero(text, Dimension::Time)
}

/// An acceleration above zero.
pub(crate) fn gravity(text: &str) -> Result<f64, String> {
    above_zero(text, Dimension::Acceleration)
}

/// A length above zero with the uncertainty it was given.
pub(crate) fn length_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Length)
}

/// A period above zero with the uncertainty it was given.
pub(crate) fn period_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Time)
}

/// A number with the uncertainty it was given.
pub(super) fn number_with_uncertainty(text: &str) -> Result<Quantity, QuantityError> {
    parse(text, Dimension::Number)
}

/// A mass above zero with the uncertainty it was given.
pub(super) fn mass_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Mass)
}

/// A density above zero with the uncertainty it was given.
pub(super) fn density_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Density)
}

/// A rate above zero with the uncertainty it was given.
pub(crate) fn rate_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Rate)
}

/// A stiffness above zero with the uncertainty it was given.
pub(super) fn stiffness_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Stiffness)
}

/// A coefficient of expansion above zero with the uncertainty it was given.
pub(super) fn expansion_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Expansion)
}

/// A temperature difference of either sign, with the given uncertainty.
pub(super) fn temperature_difference(text: &str) -> Result<Quantity, QuantityError> {
    parse(text, Dimension::TemperatureDifference)
}

/// A latitude in radians.
pub(super) fn latitude(text: &str) -> Result<f64, QuantityError> {
    let latitude = parse(text, Dimension::Angle)?;
    bare::say(text);
    Ok(value_alone(text, latitude))
}

/// An elevation in metres, which may be below sea level.
pub(super) fn elevation(text: &str) -> Result<f64, QuantityError> {
    Ok(value_alone(text, parse(text, Dimension::Length)?))
}

/// A fraction, such as 0.01 or 1%.
pub(crate) fn part(text: &str) -> Result<f64, String> {
    let (number, unit) = with_percent(text);
    let part = number.parse::<f64>().ok().map(|number| number * unit);
    part.filter(|part| (0.0..1.0).contains(part))
        .ok_or_else(|| "give a fraction of 1, such as 0.01 or 1%".to_owned())
}

/// An acceleration above zero with the uncertainty it was given.
pub(super) fn gravity_with_uncertainty(text: &str) -> Result<Quantity, String> {
    quantity_above_zero(text, Dimension::Acceleration)
}

pub(crate) fn angular_velocity(text: &str) -> Result<f64, QuantityError> {
    Ok(value_alone(text, parse(text, Dimension::AngularVelocity)?))
}

/// A time in seconds, negative ones included.
pub(crate) fn finite_time(text: &str) -> Result<f64, QuantityError> {
    Ok(value_alone(text, parse(text, Dimension::Time)?))
}

/// A plain number above zero.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "give a finite number above zero, such as 1e-3".to_owned())
}

/// A fractional error above zero, such as 1e-3 or 0.1%.
pub(crate) fn fractional_error(text: &str) -> Result<f64, String> {
    let (number, unit) = with_percent(text);
    let error = number.parse::<f64>().ok().map(|number| number * unit);
    error
        .filter(|error| error.is_finite() && *error > 0.0)
        .ok_or_else(|| "give a finite number above zero, such as 1e-3 or 0.1%".to_owned())
}

/// A number as text, and the factor by which it is multiplied.
fn with_percent(text: &str) -> (&str, f64) {
    let text = text.trim();
    text.strip_suffix('%').map_or((text, 1.0), |number| (number.trim_end(), 0.01))
}

/// A plain number that is zero or above.
pub(crate) fn not_negative(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| number.is_finite() && *number >= 0.0);
    number.ok_or_else(|| "give a finite number that is zero or above, such as 100".to_owned())
}

/// A whole number from one to `MOST`.
pub(crate) fn count<const MOST: usize>(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|number| (1..=MOST).contains(number));
    number.ok_or_else(|| format!("give a whole number from 1 to {MOST}"))
}

/// The value of a quantity, with a note if an uncertainty was given.
fn value_alone(text: &str, quantity: Quantity) -> f64 {
    if quantity.uncertainty.is_some() {
        call::current().note(&format!("the uncertainty of `{text}` is not used here, only its value"));
    }
    quantity.value
}

fn above_zero(text: &str, dimension: Dimension) -> Result<f64, String> {
    Ok(value_alone(text, quantity_above_zero(text, dimension)?))
}

fn quantity_above_zero(text: &str, dimension: Dimension) -> Result<Quantity, String> {
    let quantity = parse(text, dimension).map_err(|error| error.to_string())?;
    if quantity.value > 0.0 {
        Ok(quantity)
    } else {
        Err(format!("{dimension} must be above zero: write {}", dimension.examples()))
    }
}
