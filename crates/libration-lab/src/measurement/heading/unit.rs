//! Units as instruments spell them.

use std::fmt;
use std::str::FromStr;

use libration::quantity::{Dimension, in_si};

/// A unit of time, angle, angular velocity, frequency or length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unit {
    /// s
    Second,
    /// ms
    Millisecond,
    /// µs
    Microsecond,
    /// ns
    Nanosecond,
    /// min
    Minute,
    /// rad
    Radian,
    /// mrad
    Milliradian,
    /// °
    Degree,
    /// A whole turn.
    Turn,
    /// A step of an encoder, whose number in a turn must be given.
    Count,
    /// rad/s
    RadianPerSecond,
    /// °/s
    DegreePerSecond,
    /// Hz
    Hertz,
    /// kHz
    Kilohertz,
    /// 1/min
    PerMinute,
    /// m
    Metre,
    /// dm
    Decimetre,
    /// cm
    Centimetre,
    /// mm
    Millimetre,
    /// in
    Inch,
    /// ft
    Foot,
    /// A pixel of a picture.
    Pixel,
}

/// Quantity that a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::measurement) enum Measures {
    Time,
    Angle,
    AngularVelocity,
    Frequency,
    Length,
}

/// Each unit with the name it is printed by, and its other spellings in lower case without blanks.
const UNITS: [(Unit, &str, &[&str]); 22] = [
    (
        Unit::Second,
        "s",
        &[
            "sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden", "sekunder", "sekundy",
            "secondi", "segundos", "segundo", "secondes", "seconden", "s.", "sec.", "sek.", "с",
        ],
    ),
    (Unit::Millisecond, "ms", &["msec", "millisecond", "milliseconds", "millis"]),
    (Unit::Microsecond, "us", &["µs", "μs", "usec", "microsecond", "microseconds", "micros"]),
    (Unit::Nanosecond, "ns", &["nsec", "nanosecond", "nanoseconds"]),
    (Unit::Minute, "min", &["mins", "minute", "minutes", "minuten", "minuti", "minutos", "мин"]),
    (Unit::Radian, "rad", &["rads", "radian", "radians", "radiant", "radianti", "radianes"]),
    (Unit::Milliradian, "mrad", &["milliradian", "milliradians"]),
    (
        Unit::Degree,
        "deg",
        &[
            "°", "º", "degs", "degree", "degrees", "grad", "gradi", "grados", "degrés", "graus", "graden",
            "grader", "stopnie", "stopni",
        ],
    ),
    (Unit::Turn, "turn", &["turns", "rev", "revs", "revolution", "revolutions", "umdrehungen", "tours"]),
    (Unit::Count, "counts", &["count", "cts", "ticks", "tick", "steps", "pulses", "impulse"]),
    (
        Unit::RadianPerSecond,
        "rad/s",
        &[
            "rads/s",
            "rad/sec",
            "rads/sec",
            "radian/s",
            "radians/s",
            "radians/second",
            "rads^-1",
            "rad*s^-1",
            "rad·s^-1",
            "rads-1",
            "rads⁻¹",
            "rad·s⁻¹",
        ],
    ),
    (
        Unit::DegreePerSecond,
        "deg/s",
        &[
            "°/s",
            "º/s",
            "deg/sec",
            "degrees/s",
            "degrees/second",
            "°/sec",
            "dps",
            "°s⁻¹",
            "°·s⁻¹",
            "degs-1",
            "degs^-1",
        ],
    ),
    (Unit::Hertz, "Hz", &["hz", "hertz", "1/s", "s^-1", "s⁻¹"]),
    (Unit::Kilohertz, "kHz", &["khz", "kilohertz"]),
    (Unit::PerMinute, "1/min", &["rpm", "u/min", "rev/min", "r/min", "tr/min", "min^-1", "min⁻¹"]),
    (
        Unit::Metre,
        "m",
        &["meter", "metern", "meters", "metre", "metres", "mètre", "mètres", "metri", "metros", "metry", "м"],
    ),
    (
        Unit::Decimetre,
        "dm",
        &["decimeter", "decimetre", "decimetres", "dezimeter", "décimètre", "decimetri", "decímetros"],
    ),
    (
        Unit::Centimetre,
        "cm",
        &[
            "centimeter",
            "centimeters",
            "centimetre",
            "centimetres",
            "zentimeter",
            "zentimetern",
            "centimètre",
            "centimètres",
            "centimetri",
            "centímetros",
            "centimetros",
            "centymetry",
            "см",
        ],
    ),
    (
        Unit::Millimetre,
        "mm",
        &[
            "millimeter",
            "millimetern",
            "millimeters",
            "millimetre",
            "millimetres",
            "millimètres",
            "millimetri",
            "milímetros",
            "milimetros",
            "milimetry",
            "мм",
        ],
    ),
    (Unit::Inch, "in", &["inch", "inches", "in.", "\"", "″"]),
    (Unit::Foot, "ft", &["foot", "feet", "ft."]),
    (Unit::Pixel, "px", &["pixel", "pixels", "pix"]),
];

impl Unit {
    pub(in crate::measurement) fn measures(self) -> Measures {
        match self {
            Self::Second | Self::Millisecond | Self::Microsecond | Self::Nanosecond | Self::Minute => {
                Measures::Time
            }
            Self::Radian | Self::Milliradian | Self::Degree | Self::Turn | Self::Count => Measures::Angle,
            Self::RadianPerSecond | Self::DegreePerSecond => Measures::AngularVelocity,
            Self::Hertz | Self::Kilohertz | Self::PerMinute => Measures::Frequency,
            Self::Metre
            | Self::Decimetre
            | Self::Centimetre
            | Self::Millimetre
            | Self::Inch
            | Self::Foot
            | Self::Pixel => Measures::Length,
        }
    }

    /// Returns `true` if both are units of one quantity.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::Unit;
    /// assert!(Unit::Foot.measures_as(Unit::Metre) && Unit::Hertz.measures_as(Unit::RadianPerSecond));
    /// ```
    #[must_use]
    pub fn measures_as(self, other: Self) -> bool {
        let of = |unit: Self| match unit.measures() {
            Measures::AngularVelocity => Measures::Frequency,
            other => other,
        };
        of(self) == of(other)
    }

    /// Converts a value to seconds, radians, radians per second or metres. The result is that of the same text on a command line: the
    /// shortest decimal that reads back as the number is converted exactly and rounded once. Counts and pixels are unchanged; a frequency
    /// becomes an angular frequency.
    #[must_use]
    pub fn to_si(self, value: f64) -> f64 {
        let dimension = match self.measures() {
            Measures::Time => Dimension::Time,
            Measures::Angle => Dimension::Angle,
            Measures::AngularVelocity => Dimension::AngularVelocity,
            Measures::Frequency => return std::f64::consts::TAU * self.in_hertz() * value,
            Measures::Length => Dimension::Length,
        };
        in_si(value, self.name(), dimension).unwrap_or(value)
    }

    fn in_hertz(self) -> f64 {
        match self {
            Self::Kilohertz => 1e3,
            Self::PerMinute => 1.0 / 60.0,
            _ => 1.0,
        }
    }

    fn name(self) -> &'static str {
        UNITS.iter().find(|(unit, ..)| *unit == self).map_or("", |(_, name, _)| name)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.name())
    }
}

/// No unit that is known here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("it is not a known unit: give one such as s, ms, us, rad, deg, rad/s, deg/s")]
pub struct UnknownUnit;

impl FromStr for Unit {
    type Err = UnknownUnit;
    fn from_str(text: &str) -> Result<Self, UnknownUnit> {
        let plain: String = text.to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
        let spelled =
            |(_, name, others): &&(Self, &str, &[&str])| *name == plain || others.contains(&plain.as_str());
        UNITS.iter().find(spelled).map(|(unit, ..)| *unit).ok_or(UnknownUnit)
    }
}
