//! Physical quantities from text: `1.2 m`, `35 in`, `9.81m/s^2`, `1.200(3) m`, `1.200 ± 0.003 m`.
//!
//! The product of the decimal and the unit is exact, and rounded once.

use dashu_base::Abs;
use dashu_ratio::RBig;

use super::decimal::{Decimal, LONGEST_TEXT, exponent_length};
use super::excerpt::excerpt;
use super::pi_combination::PiCombination;
use super::unit::Unit;
use super::{Dimension, QuantityError};

/// A value in its SI unit with its standard uncertainty, if one was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// The value in the SI unit of the dimension, finite.
    pub value: f64,
    /// One standard deviation in the same unit, finite and not negative.
    pub uncertainty: Option<f64>,
}

/// Reads a quantity of this dimension; a bare number is in the SI unit.
///
/// The uncertainty may be in brackets in units of the last digit, after `±`, `+-` or `+/-` with or without a unit, or a percentage. With
/// `rectangular` or `rect` at the end it is the half-width of an interval with equal probability everywhere, whose standard uncertainty is the
/// half-width over √3 (JCGM 100:2008, 4.3.7).
///
/// # Errors
/// Text that is not a number with a unit, a unit of another dimension, or a number beyond the range of `f64`.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::{Dimension, parse};
///
/// let length = parse("120.0(3) cm", Dimension::Length)?;
/// assert_eq!((length.value, length.uncertainty), (1.2, Some(0.003)));
/// let ruler = parse("120.0 ± 0.5 mm rectangular", Dimension::Length)?;
/// assert!((ruler.uncertainty.unwrap_or(0.0) - 0.5e-3 / 3.0_f64.sqrt()).abs() < 1e-18);
/// assert!(parse("1 s", Dimension::Length).is_err());
/// # Ok::<(), libration::quantity::QuantityError>(())
/// ```
pub fn parse(text: &str, dimension: Dimension) -> Result<Quantity, QuantityError> {
    let Some(interval) = interval(text) else { return with_standard_uncertainty(text, dimension) };
    let Quantity { value, uncertainty } = with_standard_uncertainty(interval, dimension)?;
    let half_width =
        uncertainty.ok_or_else(|| QuantityError::UnreadableQuantity { text: excerpt(text), dimension })?;
    Ok(Quantity { value, uncertainty: Some(half_width / 3.0_f64.sqrt()) })
}

/// The text without the word at its end that makes the uncertainty a half-width; `None` without the word.
fn interval(text: &str) -> Option<&str> {
    let text = text.trim_end();
    text.strip_suffix("rectangular").or_else(|| text.strip_suffix("rect"))
}

fn with_standard_uncertainty(text: &str, dimension: Dimension) -> Result<Quantity, QuantityError> {
    let exact = ExactQuantity::parse(text, dimension)?;
    let out_of_range = || QuantityError::QuantityOutOfRange { text: excerpt(text), dimension };
    let value = exact.value.nearest().ok_or_else(out_of_range)?;
    let uncertainty = match exact.uncertainty {
        Some(sigma) if sigma.value().is_negative() => return Err(out_of_range()),
        Some(sigma) => Some(sigma.nearest().ok_or_else(out_of_range)?),
        None => None,
    };
    Ok(Quantity { value, uncertainty })
}

/// The value of a number with a unit, as [`parse`] reads the shortest decimal of the number: in the SI unit of the dimension, rounded once. A
/// number that is not finite is returned unchanged; `None` if the unit is unknown or of another dimension, and beyond the range of `f64`.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::{Angle, Dimension, in_si};
///
/// let angle = in_si(30.0, "deg", Dimension::Angle).ok_or("degrees measure angles")?;
/// assert_eq!(angle, "30deg".parse::<Angle>()?.radians());
/// // The product of two rounded numbers differs from the correctly rounded value.
/// assert_ne!(angle, 30.0 * (std::f64::consts::PI / 180.0));
/// assert_eq!(in_si(1.0, "s", Dimension::Angle), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn in_si(number: f64, unit: &str, dimension: Dimension) -> Option<f64> {
    let unit = Unit::named(unit, dimension).filter(|unit| unit.dimension == dimension)?;
    if number.is_finite() { unit.to_si(number) } else { Some(number) }
}

/// A quantity before rounding, in its SI unit.
pub(super) struct ExactQuantity {
    pub(super) value: PiCombination,
    uncertainty: Option<PiCombination>,
}

impl ExactQuantity {
    pub(super) fn parse(text: &str, dimension: Dimension) -> Result<Self, QuantityError> {
        let unreadable = || QuantityError::UnreadableQuantity { text: excerpt(text), dimension };
        if text.len() > LONGEST_TEXT {
            return Err(unreadable());
        }
        let plain = plain(text);
        let (value, spread) = plain.split_once('±').map_or((plain.as_str(), None), |(v, s)| (v, Some(s)));
        let value = Amount::parse(value).ok_or_else(unreadable)?;
        let spread = spread.map(|spread| Amount::parse(spread).ok_or_else(unreadable)).transpose()?;
        let shared = spread.as_ref().map_or("", |spread| spread.unit);
        let unit_name = if value.unit.is_empty() && shared != PERCENT { shared } else { value.unit };
        let unit = unit_named(unit_name, text, dimension)?;
        let number = value.number.exact();
        let uncertainty = match (spread, value.last_digits) {
            (None, last_digits) => last_digits.map(|digits| unit.times(digits)),
            (Some(_), Some(_)) => return Err(unreadable()),
            (Some(spread), None) => Some(match spread.unit {
                "" => unit.times(spread.number.exact()),
                PERCENT => unit.times(number.clone().abs() * spread.number.exact() / RBig::from(100)),
                name => unit_named(name, text, dimension)?.times(spread.number.exact()),
            }),
        };
        Ok(Self { value: unit.times(number), uncertainty })
    }
}

const PERCENT: &str = "%";

/// The text with one spelling of the signs, and without brackets around value and uncertainty.
fn plain(text: &str) -> String {
    let text = text.trim().replace('−', "-").replace("+/-", "±").replace("+-", "±");
    match text.strip_prefix('(').and_then(|rest| rest.rsplit_once(')')) {
        Some((inside, unit)) => format!("{inside} {unit}"),
        None => text,
    }
}

/// Returns `true` if a number in the text would have two points with its comma as one, as in `0.5,0.001`.
fn has_two_points(text: &str) -> bool {
    let mut numbers = text.split(|letter: char| !letter.is_ascii_digit() && letter != ',' && letter != '.');
    numbers.any(|number| number.matches([',', '.']).count() > 1)
}

fn unit_named(name: &str, text: &str, dimension: Dimension) -> Result<&'static Unit, QuantityError> {
    if name.is_empty() {
        return Ok(Unit::si(dimension));
    }
    let is_decimal =
        |rest: &str| rest.starts_with(|letter: char| letter.is_ascii_digit()) && !has_two_points(text);
    if name.strip_prefix(',').is_some_and(is_decimal) {
        return Err(QuantityError::DecimalComma {
            text: excerpt(text),
            with_point: excerpt(&text.replace(',', ".")),
        });
    }
    let Some(unit) = Unit::named(name, dimension) else {
        return Err(QuantityError::UnknownUnit { text: excerpt(text), unit: excerpt(name), dimension });
    };
    if unit.dimension != dimension {
        return Err(QuantityError::WrongDimension { text: excerpt(text), found: unit.dimension, dimension });
    }
    Ok(unit)
}

/// A number, possibly with an uncertainty of its last digits, and the name of a unit.
struct Amount<'a> {
    number: Decimal,
    last_digits: Option<RBig>,
    unit: &'a str,
}

impl<'a> Amount<'a> {
    fn parse(text: &'a str) -> Option<Self> {
        let text = text.trim();
        let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text).trim_start();
        let (number, last_digits, unit) = concise(unsigned).or_else(|| {
            let (number, unit) = Decimal::split_from(unsigned)?;
            Some((number, None, unit))
        })?;
        let number = if text.starts_with('-') { number.negated() } else { number };
        Some(Self { number, last_digits, unit: unit.trim() })
    }
}

/// A number such as `1.200(3)` or `1.200(3)e-2`, its uncertainty, and the rest of the text.
fn concise(text: &str) -> Option<(Decimal, Option<RBig>, &str)> {
    let (mantissa, rest) = text.split_once('(')?;
    let (digits, rest) = rest.split_once(')')?;
    let (exponent, unit) = rest.split_at(exponent_length(rest.as_bytes()));
    let written = format!("{mantissa}{exponent}");
    let (number, _) = Decimal::split_from(&written).filter(|(_, rest)| rest.is_empty())?;
    let uncertainty = RBig::from(digits.parse::<u32>().ok()?) * number.last_place();
    Some((number, Some(uncertainty), unit))
}
