//! The units that quantities are read in, each with its exact value.

use std::fmt;

use dashu::rational::RBig;

use super::pi_combination::PiCombination;

/// What a quantity measures, and with it the SI unit its value is kept in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Dimension {
    /// In metres.
    Length,
    /// In seconds.
    Time,
    /// In metres per second squared.
    Acceleration,
    /// In radians per second.
    AngularVelocity,
    /// In metres per second.
    Velocity,
    /// In kilograms.
    Mass,
    /// In kilograms per cubic metre.
    Density,
    /// In one per second.
    Rate,
}

impl Dimension {
    /// Some ways to write a quantity of this dimension.
    #[must_use]
    pub fn examples(self) -> &'static str {
        match self {
            Self::Length => "1m, 120 cm, 35 in, 1.200(3) m or 1.200 ± 0.003 m (a bare number is in metres)",
            Self::Time => "2s, 500ms, 2.007(2) s or 2.007 ± 0.002 s (a bare number is in seconds)",
            Self::Acceleration => "9.81m/s^2, 981 cm/s^2 or 9.81 ± 0.02 m/s^2 (a bare number is in m/s^2)",
            Self::AngularVelocity => "0.3rad/s, 30deg/s or 33 rpm (a bare number is in rad/s)",
            Self::Velocity => "0.3m/s, 20 cm/s or 5 km/h (a bare number is in m/s)",
            Self::Mass => "31g, 2.032 kg or 42.0 ± 0.5 g (a bare number is in kilograms)",
            Self::Density => "7850kg/m^3, 7.85 g/cm^3 or 1.20(2) kg/m^3 (a bare number is in kg/m^3)",
            Self::Rate => "0.03/s, 0.030(1)/s or 0.030 ± 0.001 1/s (a bare number is in 1/s)",
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Length => "a length",
            Self::Time => "a time",
            Self::Acceleration => "an acceleration",
            Self::AngularVelocity => "an angular velocity",
            Self::Velocity => "a velocity",
            Self::Mass => "a mass",
            Self::Density => "a density",
            Self::Rate => "a rate",
        })
    }
}

/// A unit: its value is numerator/denominator of the SI unit, times π where it counts half turns.
pub(super) struct Unit {
    pub(super) dimension: Dimension,
    names: &'static [&'static str],
    numerator: i64,
    denominator: u64,
    of: Factor,
}

enum Factor {
    One,
    Pi,
}

impl Unit {
    /// The unit of this name; where several bear it (g), the one of this dimension.
    pub(super) fn named(name: &str, dimension: Dimension) -> Option<&'static Self> {
        let mut bearers = UNITS.iter().filter(|unit| unit.names.contains(&name));
        bearers.clone().find(|unit| unit.dimension == dimension).or_else(|| bearers.next())
    }

    pub(super) fn si(dimension: Dimension) -> &'static Self {
        UNITS
            .iter()
            .find(|unit| unit.dimension == dimension)
            .expect("the table begins each dimension with its SI unit")
    }

    /// So many of this unit, in the SI unit.
    pub(super) fn times(&self, number: RBig) -> PiCombination {
        let value = number * RBig::from_parts(self.numerator.into(), self.denominator.into());
        match self.of {
            Factor::One => PiCombination { pi_multiple: RBig::ZERO, rest: value },
            Factor::Pi => PiCombination { pi_multiple: value, rest: RBig::ZERO },
        }
    }
}

const fn unit(
    dimension: Dimension,
    names: &'static [&'static str],
    numerator: i64,
    denominator: u64,
) -> Unit {
    Unit { dimension, names, numerator, denominator, of: Factor::One }
}

const fn half_turns_per_second(names: &'static [&'static str], numerator: i64, denominator: u64) -> Unit {
    Unit { dimension: Dimension::AngularVelocity, names, numerator, denominator, of: Factor::Pi }
}

/// The SI unit of each dimension comes first. The inch is 25.4 mm and the foot twelve of them (international,
/// 1959); the standard acceleration of gravity is 9.80665 m/s² (CGPM 1901), the pound 0.45359237 kg
/// (international, 1959).
static UNITS: [Unit; 34] = [
    unit(Dimension::Length, &["m", "metre", "metres", "meter", "meters"], 1, 1),
    unit(Dimension::Length, &["km"], 1000, 1),
    unit(Dimension::Length, &["dm"], 1, 10),
    unit(Dimension::Length, &["cm"], 1, 100),
    unit(Dimension::Length, &["mm"], 1, 1000),
    unit(Dimension::Length, &["um", "µm", "μm"], 1, 1_000_000),
    unit(Dimension::Length, &["in", "inch", "inches", "″"], 254, 10_000),
    unit(Dimension::Length, &["ft", "foot", "feet"], 3048, 10_000),
    unit(Dimension::Time, &["s", "sec", "second", "seconds"], 1, 1),
    unit(Dimension::Time, &["ms"], 1, 1000),
    unit(Dimension::Time, &["us", "µs", "μs"], 1, 1_000_000),
    unit(Dimension::Time, &["min"], 60, 1),
    unit(Dimension::Time, &["h"], 3600, 1),
    unit(Dimension::Acceleration, &["m/s^2", "m/s²", "m/s2", "m/s/s", "m s^-2", "m s⁻²", "m·s⁻²"], 1, 1),
    unit(Dimension::Acceleration, &["cm/s^2", "cm/s²", "cm/s2", "Gal"], 1, 100),
    unit(Dimension::Acceleration, &["ft/s^2", "ft/s²", "ft/s2"], 3048, 10_000),
    unit(Dimension::Acceleration, &["g", "gn", "g0", "g_n"], 980_665, 100_000),
    unit(Dimension::AngularVelocity, &["rad/s", "rad s^-1", "rad s⁻¹", "rad·s⁻¹"], 1, 1),
    half_turns_per_second(&["deg/s", "°/s", "deg s^-1"], 1, 180),
    half_turns_per_second(&["rev/s", "turn/s", "turns/s"], 2, 1),
    half_turns_per_second(&["rpm", "rev/min"], 1, 30),
    unit(Dimension::Velocity, &["m/s", "m s^-1", "m s⁻¹", "m·s⁻¹"], 1, 1),
    unit(Dimension::Velocity, &["km/h"], 10, 36),
    unit(Dimension::Velocity, &["cm/s"], 1, 100),
    unit(Dimension::Velocity, &["mm/s"], 1, 1000),
    unit(Dimension::Velocity, &["ft/s"], 3048, 10_000),
    unit(Dimension::Mass, &["kg"], 1, 1),
    unit(Dimension::Mass, &["g", "gram", "grams"], 1, 1000),
    unit(Dimension::Mass, &["mg"], 1, 1_000_000),
    unit(Dimension::Mass, &["lb"], 45_359_237, 100_000_000),
    unit(Dimension::Density, &["kg/m^3", "kg/m³", "kg/m3", "kg m^-3", "kg m⁻³", "g/l", "g/L"], 1, 1),
    unit(
        Dimension::Density,
        &["g/cm^3", "g/cm³", "g/cm3", "g cm^-3", "g/ml", "g/mL", "kg/l", "kg/L"],
        1000,
        1,
    ),
    unit(Dimension::Rate, &["/s", "1/s", "s^-1", "s⁻¹", "per second"], 1, 1),
    unit(Dimension::Rate, &["/min", "1/min", "min^-1", "min⁻¹", "per minute"], 1, 60),
];
