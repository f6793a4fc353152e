//! Angles from text: `60deg`, `1.2rad`, `1.2`, `pi/3`, and below the top `pi-1e-300`, `180deg-1e-9deg`.
//!
//! An angle is one term, or a term in degrees or in π with a second one added or subtracted. A term alone in
//! radians is the nearest `f64`; every other number is the exact decimal.

use std::str::FromStr;

use dashu_base::Signed;
use dashu_ratio::RBig;

use super::angle::LARGEST_RADIANS;
use super::decimal::{Decimal, LONGEST_TEXT};
use super::excerpt::excerpt;
use super::pi_combination::PiCombination;
use super::unit::DEGREE;
use super::{Angle, QuantityError};

const HOW_TO_WRITE: &str = "write 60deg, 1.2rad, pi-1e-6 or 180deg-1e-9deg";
const DECIMAL_COMMA: &str = "write the decimals with a point, as in 1.2rad";
const SAY_THE_UNIT: &str = "write the unit of what is taken from degrees, as in 180deg-1e-9deg";
const TOO_LARGE: &str = "give an angle of at most 2^53 rad";
const TOO_SMALL: &str = "give zero or at least 1e-300 rad, and the top exactly or by at least 1e-300 rad";
/// Smallest distance from zero or the top: below it the second word of an angle would be subnormal.
const SMALLEST: f64 = 1e-300;

/// Reads an angle.
///
/// # Errors
/// Text that does not follow the grammar or is longer than 128 bytes; an angle of more than 2⁵³ rad; a decimal angle within 1e-300 rad of zero
/// or of the top, but not there.
impl FromStr for Angle {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        // A fast path for plain numbers, the most frequent lines in files of angles.
        let plain = if text.len() <= LONGEST_TEXT { Decimal::nearest_to(text) } else { None };
        if let Some(angle) = plain.and_then(|radians| Self::from_radians(radians).ok()) {
            return Ok(angle);
        }
        let angle = terms(text).and_then(|(first, second)| match second {
            None => first.alone(),
            Some(second) => in_range(&first.followed_by(&second)?),
        });
        angle.map_err(|fault| fault.about(text))
    }
}

/// The angle of the text with all its numbers as exact decimals, within the range of angles.
pub(super) fn exact_angle(text: &str) -> Result<PiCombination, QuantityError> {
    let angle = terms(text).and_then(|(first, second)| {
        let angle = second.map_or(Ok(first.exact()), |second| first.followed_by(&second))?;
        in_range(&angle).map(|_| angle)
    });
    angle.map_err(|fault| fault.about(text))
}

/// An error to which the text is still to be added.
enum AngleFault {
    Unreadable(&'static str),
    OutOfRange(&'static str),
}

impl AngleFault {
    fn about(self, text: &str) -> QuantityError {
        match self {
            Self::Unreadable(hint) => QuantityError::UnreadableAngle { text: excerpt(text), hint },
            Self::OutOfRange(hint) => QuantityError::AngleOutOfRange { text: excerpt(text), hint },
        }
    }
}

fn terms(text: &str) -> Result<(AngleTerm, Option<AngleTerm>), AngleFault> {
    if text.len() > LONGEST_TEXT {
        return Err(AngleFault::Unreadable(HOW_TO_WRITE));
    }
    let plain = text.trim().replace('−', "-").replace('π', "pi").to_ascii_lowercase();
    let (first, second) = split_at_second_sign(&plain);
    let second = if second.is_empty() { None } else { Some(AngleTerm::parse(second)?) };
    Ok((AngleTerm::parse(first)?, second))
}

/// The first term, and the second with its sign; the sign of an exponent is ignored.
fn split_at_second_sign(text: &str) -> (&str, &str) {
    let is_sign = |b: u8| b == b'+' || b == b'-';
    let bytes = text.as_bytes();
    let exponent_at = |i: usize| bytes[i] == b'e' && i > 0 && matches!(bytes[i - 1], b'0'..=b'9' | b'.');
    let second = (1..bytes.len()).find(|&i| is_sign(bytes[i]) && !exponent_at(i - 1));
    text.split_at(second.unwrap_or(text.len()))
}

enum AngleUnit {
    Unsaid,
    Radians,
    Degrees,
    Pi,
}

/// A signed number with its unit.
struct AngleTerm {
    number: Decimal,
    divisor: RBig,
    unit: AngleUnit,
}

impl AngleTerm {
    fn parse(text: &str) -> Result<Self, AngleFault> {
        let (negative, unsigned) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let unsigned = unsigned.trim();
        let one = || Decimal::split_from("1").map(|(one, _)| (one, unsigned));
        let (number, rest) = Decimal::split_from(unsigned)
            .or_else(|| if unsigned.starts_with("pi") { one() } else { None })
            .ok_or(AngleFault::Unreadable(HOW_TO_WRITE))?;
        let (unit, divisor) = unit_and_divisor(rest.trim())?;
        Ok(Self { number: if negative { number.negated() } else { number }, divisor, unit })
    }

    fn alone(&self) -> Result<Angle, AngleFault> {
        match self.unit {
            AngleUnit::Unsaid | AngleUnit::Radians => {
                Angle::from_radians(self.number.nearest()).map_err(|_| AngleFault::OutOfRange(TOO_LARGE))
            }
            AngleUnit::Degrees | AngleUnit::Pi => in_range(&self.exact()),
        }
    }

    fn followed_by(&self, second: &Self) -> Result<PiCombination, AngleFault> {
        match (&self.unit, &second.unit) {
            (AngleUnit::Unsaid | AngleUnit::Radians, _) => return Err(AngleFault::Unreadable(HOW_TO_WRITE)),
            (AngleUnit::Degrees, AngleUnit::Unsaid) => return Err(AngleFault::Unreadable(SAY_THE_UNIT)),
            (AngleUnit::Degrees | AngleUnit::Pi, _) => {}
        }
        let (a, b) = (self.exact(), second.exact());
        Ok(PiCombination { pi_multiple: a.pi_multiple + b.pi_multiple, rest: a.rest + b.rest })
    }

    fn exact(&self) -> PiCombination {
        let number = self.number.exact() / &self.divisor;
        match self.unit {
            AngleUnit::Unsaid | AngleUnit::Radians => PiCombination { pi_multiple: RBig::ZERO, rest: number },
            AngleUnit::Degrees => DEGREE.times(number),
            AngleUnit::Pi => PiCombination { pi_multiple: number, rest: RBig::ZERO },
        }
    }
}

/// The unit after a number, and the divisor of a multiple of π.
fn unit_and_divisor(text: &str) -> Result<(AngleUnit, RBig), AngleFault> {
    let unit = match text {
        "" => AngleUnit::Unsaid,
        "rad" | "radian" | "radians" => AngleUnit::Radians,
        "deg" | "degree" | "degrees" | "°" => AngleUnit::Degrees,
        _ if text.starts_with(',') => return Err(AngleFault::Unreadable(DECIMAL_COMMA)),
        _ => return Ok((AngleUnit::Pi, divisor_of_pi(text).ok_or(AngleFault::Unreadable(HOW_TO_WRITE))?)),
    };
    Ok((unit, RBig::ONE))
}

/// The n of `pi/n`, one for `pi`, after an optional `*` and before an optional `rad`.
fn divisor_of_pi(text: &str) -> Option<RBig> {
    let text = text.strip_prefix('*').unwrap_or(text).trim_start().strip_prefix("pi")?.trim();
    let text = text.strip_suffix("rad").unwrap_or(text).trim_end();
    if text.is_empty() {
        return Some(RBig::ONE);
    }
    let divisor = Decimal::parse(text.strip_prefix('/')?.trim_start())?.exact();
    (!divisor.is_zero() && divisor.is_positive()).then_some(divisor)
}

/// The angle, if its turns can be counted and its words are normal numbers.
fn in_range(angle: &PiCombination) -> Result<Angle, AngleFault> {
    if angle.value().to_words().hi.abs() > LARGEST_RADIANS {
        return Err(AngleFault::OutOfRange(TOO_LARGE));
    }
    let exactly_at_an_end = angle.is_multiple_of_pi();
    let angle = angle.to_angle();
    if !exactly_at_an_end && angle.in_turn().abs().min(angle.complement()) < SMALLEST {
        return Err(AngleFault::OutOfRange(TOO_SMALL));
    }
    Ok(angle)
}
