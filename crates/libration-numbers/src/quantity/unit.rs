//! The units of quantities, each with its exact value.

use dashu_ratio::RBig;

use super::dimension::Dimension;
use super::pi_combination::PiCombination;
use super::shortest::{Shortest, exactly};
use libration_kernels::double_double::DoubleDouble;

/// A unit: its value is numerator/denominator of the SI unit, times π if it counts half turns.
pub(super) struct Unit {
    pub(super) dimension: Dimension,
    names: &'static [&'static str],
    numerator: i64,
    denominator: u64,
    of: Factor,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Factor {
    One,
    Pi,
}

/// The degree, for text of angles and for numbers of degrees.
pub(super) const DEGREE: Unit = half_turns(Dimension::Angle, &["deg", "degree", "degrees", "°"], 1, 180);

impl Unit {
    /// The unit with this name; if several have it (g), the one of this dimension.
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

    /// A number of this unit, as an exact value in the SI unit.
    pub(super) fn times(&self, number: RBig) -> PiCombination {
        let value = number * RBig::from_parts(self.numerator.into(), self.denominator.into());
        match self.of {
            Factor::One => PiCombination { pi_multiple: RBig::ZERO, rest: value },
            Factor::Pi => PiCombination { pi_multiple: value, rest: RBig::ZERO },
        }
    }

    /// A number of this unit in the SI unit, rounded once; `None` beyond the range of `f64`.
    pub(super) fn to_si(&self, number: f64) -> Option<f64> {
        if number == 0.0 || (self.numerator, self.denominator, &self.of) == (1, 1, &Factor::One) {
            return Some(number);
        }
        let number = Shortest::new(number);
        self.to_si_in_two_words(&number).or_else(|| self.times(number.decimal()?.exact()).nearest())
    }

    /// The number in the SI unit, if two words decide the rounding: each of the four operations on them has a relative error below 2⁻¹⁰⁰.
    fn to_si_in_two_words(&self, number: &Shortest) -> Option<f64> {
        const ERROR: f64 = 4.0 * f64::EPSILON * f64::EPSILON * 16.0;
        let below = exactly(i64::try_from(self.denominator).ok()?)?;
        let factor = DoubleDouble::from(exactly(self.numerator)?) / DoubleDouble::from(below);
        let in_radians = if self.of == Factor::Pi { factor * DoubleDouble::PI } else { factor };
        let DoubleDouble { hi, lo } = number.in_two_words()? * in_radians;
        let half_spacing = 0.5 * (hi.abs() - hi.abs().next_down());
        (hi.is_normal() && lo.abs() + ERROR * hi.abs() < half_spacing).then_some(hi)
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

const fn half_turns(
    dimension: Dimension,
    names: &'static [&'static str],
    numerator: i64,
    denominator: u64,
) -> Unit {
    Unit { dimension, names, numerator, denominator, of: Factor::Pi }
}

/// The SI unit of each dimension comes first. The inch is 25.4 mm and the foot twelve inches (international, 1959); the standard acceleration of
/// gravity is 9.80665 m/s² (CGPM 1901), the pound 0.45359237 kg (international, 1959).
static UNITS: [Unit; 46] = [
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
    unit(Dimension::Time, &["ns"], 1, 1_000_000_000),
    unit(Dimension::Time, &["min"], 60, 1),
    unit(Dimension::Time, &["h"], 3600, 1),
    unit(Dimension::Acceleration, &["m/s^2", "m/s²", "m/s2", "m/s/s", "m s^-2", "m s⁻²", "m·s⁻²"], 1, 1),
    unit(Dimension::Acceleration, &["cm/s^2", "cm/s²", "cm/s2", "Gal"], 1, 100),
    unit(Dimension::Acceleration, &["ft/s^2", "ft/s²", "ft/s2"], 3048, 10_000),
    unit(Dimension::Acceleration, &["g", "gn", "g0", "g_n"], 980_665, 100_000),
    unit(Dimension::Angle, &["rad", "radian", "radians"], 1, 1),
    unit(Dimension::Angle, &["mrad"], 1, 1000),
    DEGREE,
    half_turns(Dimension::Angle, &["turn", "turns", "rev"], 2, 1),
    unit(Dimension::AngularVelocity, &["rad/s", "rad s^-1", "rad s⁻¹", "rad·s⁻¹"], 1, 1),
    half_turns(Dimension::AngularVelocity, &["deg/s", "°/s", "deg s^-1"], 1, 180),
    half_turns(Dimension::AngularVelocity, &["rev/s", "turn/s", "turns/s"], 2, 1),
    half_turns(Dimension::AngularVelocity, &["rpm", "rev/min"], 1, 30),
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
    unit(Dimension::Stiffness, &["N/m", "N m^-1", "N m⁻¹", "N·m⁻¹", "kg/s^2"], 1, 1),
    unit(Dimension::Stiffness, &["N/mm"], 1000, 1),
    unit(Dimension::TemperatureDifference, &["K", "kelvin", "kelvins"], 1, 1),
    unit(Dimension::Expansion, &["/K", "1/K", "K^-1", "K⁻¹"], 1, 1),
    unit(Dimension::Expansion, &["ppm/K", "um/m/K", "µm/m/K"], 1, 1_000_000),
    unit(Dimension::Number, &["1"], 1, 1),
    unit(Dimension::Number, &["%"], 1, 100),
];
