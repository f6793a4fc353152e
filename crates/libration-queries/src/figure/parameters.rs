//! Parameters of a picture, as a line under its title: `l = 1 m`, `g = 9.80665 m/s²`, `θ₀ = 60°`.

use super::names::symbol;
use crate::output::number::{self, short};
use crate::output::series::subscript;
use libration::decay::{Damping, PowerLawTerm};
use libration::quantity::{Angle, Quantity};
use libration::systems::{Model, NamedSystem};

/// Digits of a parameter.
const DIGITS: usize = 6;
/// More numbers of a start than this are not listed.
const MOST_OF_START: usize = 6;

/// Length (m) and gravity (m/s²) of a pendulum.
pub(crate) fn of_pendulum(length: f64, gravity: f64) -> [String; 2] {
    [said("l", length, "m"), said("g", gravity, "m/s²")]
}

/// An angle of release.
pub fn amplitude(radians: f64) -> String {
    format!("θ₀ = {}°", shown(radians.to_degrees()))
}

/// The start of a pendulum: its amplitude, or its angle and angular velocity (rad/s).
pub(crate) fn of_release(angle: Angle, velocity: f64) -> Vec<String> {
    if velocity.abs() > 0.0 {
        let angle = said("θ(0)", angle.degrees(), "°").replace(" °", "°");
        vec![angle, said("θ′(0)", velocity, "rad/s")]
    } else {
        vec![amplitude(angle.radians())]
    }
}

/// A parameter with its value and unit.
pub fn said(name: &str, value: f64, unit: &str) -> String {
    format!("{} = {} {}", symbol(name), shown(value), unit.replace("^2", "²")).trim_end().to_owned()
}

/// A result with its uncertainty, if it is known.
pub(crate) fn estimate(name: &str, value: impl Into<Quantity>, unit: &str) -> String {
    let value: Quantity = value.into();
    match value.uncertainty {
        Some(uncertainty) => {
            format!("{name} = ({})", number::with_uncertainty(value.value, uncertainty, ""))
                .replace(" )", ")")
                + " "
                + unit
        }
        None => said(name, value.value, unit),
    }
}

/// The values of a system's parameters, except zeros that remove a term.
pub(crate) fn of_model(model: &Model) -> Vec<String> {
    let units =
        model.key().and_then(|key| NamedSystem::by_key(key).ok()).map_or(&[][..], |named| named.parameters);
    let parameter = |(name, _): &(String, _)| {
        let value = model.value_of(name).filter(|value| value.abs() > 0.0)?;
        let unit =
            units.iter().find(|parameter| parameter.name == name).map_or("", |parameter| parameter.unit);
        Some(said(name, value, if unit == "1" { "" } else { unit }))
    };
    model.values().iter().filter_map(parameter).collect()
}

/// The unit of the angles of an initial state: that of the axes of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AngleUnit {
    Degrees,
    Radians,
}

/// The initial state, if it has few components: `θ₁(0) = 60°`. Components at rest are omitted.
pub(crate) fn of_start(model: &Model, state: &[f64], angles: AngleUnit) -> Vec<String> {
    let named = model.state_names().into_iter().zip(model.state_units()).zip(state);
    let moved: Vec<_> = named.filter(|(_, value)| value.abs() > 0.0).collect();
    let number = |((name, unit), value): &((String, String), &f64)| {
        let name = format!("{}(0)", symbol(name));
        if unit == "rad" && angles == AngleUnit::Degrees {
            format!("{name} = {}°", shown(value.to_degrees()))
        } else {
            said(&name, **value, unit)
        }
    };
    if moved.len() > MOST_OF_START { vec![] } else { moved.iter().map(number).collect() }
}

/// The coefficients of a damping, each with its power of the velocity.
pub(crate) fn of_damping(damping: &Damping) -> Vec<String> {
    let term = |term: &PowerLawTerm| {
        let power = [0_usize, 1, 2, 3].into_iter().zip([0.0, 1.0, 2.0, 3.0]);
        let exponent = power.into_iter().find(|(_, power)| (power - term.exponent).abs() <= 0.0);
        let name = exponent
            .map_or_else(|| format!("c({})", short(term.exponent, 3)), |(n, _)| format!("c{}", subscript(n)));
        let unit = ["rad/s²", "1/s", "1/rad", "s/rad²"];
        said(&name, term.coefficient, exponent.and_then(|(n, _)| unit.get(n).copied()).unwrap_or(""))
    };
    damping.terms().iter().map(term).collect()
}

fn shown(value: f64) -> String {
    short(value, DIGITS).replace('-', "−")
}
