//! The catalogue entry of a named system.

use libration_numbers::expression::{Expression, Function};
use libration_numbers::quantity::STANDARD_GRAVITY;
use libration_numbers::{catalogue::NamedParameter, internals::catalogue::Named};

/// A system of the literature, as data.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::systems::{Model, NamedSystem};
/// let named = NamedSystem::by_key("damped_pendulum")?;
/// let model = Model::named(named, &[("c", "0.1".parse()?), ("n", "2".parse()?)], &[])?;
/// assert_eq!(model.equation().to_string(), "theta'' + 0.1*(theta'*abs(theta')) + sin(theta) = 0");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NamedSystem {
    /// The name by which it is requested.
    pub key: &'static str,
    /// Alternative names.
    pub also: &'static [&'static str],
    /// The name used in a sentence.
    pub title: &'static str,
    /// The equations of motion, several with `;` between them. If the system has a count,
    /// n, one of them ends with `i = 1..n`, and others may define `x[0]` and `x[n+1]`.
    pub equations: &'static str,
    /// The coordinates, in the order of the equations; `x[i]` stands for as many as the count.
    pub coordinates: &'static [NamedCoordinate],
    /// The parameters in the equations. With their default values all damping and driving is zero.
    pub parameters: &'static [NamedParameter],
    /// The energy as a formula of coordinates, velocities and parameters; empty if there is none, or if it is a sum over a counted family.
    pub energy: &'static str,
    /// The unit of the energy, with its divisor; empty without a formula of the energy.
    pub energy_unit: &'static str,
    /// The energy gained per unit of time: `0` if it is conserved, empty without a formula.
    pub power: &'static str,
    /// The parameter that is the angular frequency of a periodic drive.
    pub drive_frequency: Option<&'static str>,
    /// The parameter that counts the bodies, and occurs in the equations as the end of a range.
    pub count: Option<&'static str>,
    /// The allowed values of the parameter n if it is a power of a velocity.
    pub velocity_power: Option<VelocityPower>,
    /// The bodies of the system and their supports.
    pub bodies: &'static [NamedBody],
    /// A description of the system, and of how its coordinates are measured.
    pub description: &'static str,
    /// The motions and parameters for which the equations hold.
    pub domain: &'static str,
    /// The source, confirmed in the work itself or in a text that cites it; a source that was not read
    /// but remembered begins with `attributed to` and ends with `not verified against the original`.
    pub source: &'static str,
}

/// The allowed powers of a velocity: none below zero, which grow without bound at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VelocityPower {
    /// Integer powers, of the velocity with its sign.
    Whole,
    /// Any power, of the magnitude of the velocity.
    Any,
}

/// A body of a named system, in the vertical plane: lengths in metres if the system has metres,
/// and otherwise in lengths of the rod. Formulas of the coordinates, the parameters and the time.
#[derive(Clone, Copy, Debug)]
pub struct NamedBody {
    /// The position of the body, to the right and upwards.
    pub place: [&'static str; 2],
    /// The position of the other end of the rod or the spring that holds the body.
    pub pivot: [&'static str; 2],
}

/// A coordinate of a named system.
#[derive(Clone, Copy, Debug)]
pub struct NamedCoordinate {
    /// The name in the equations.
    pub name: &'static str,
    /// The unit: `rad` for angles; empty if there is none.
    pub unit: &'static str,
    /// The value at rest, as a formula of the parameters.
    pub at_rest: &'static str,
}

impl Named for NamedSystem {
    const KIND: &'static str = "system";
    const OTHERWISE: &'static str = "; or write its equations, as x'' = y - x; y'' = x - y";

    fn keys(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.key).chain(self.also.iter().copied())
    }
}

impl NamedSystem {
    /// The values of the parameters for a pendulum of this length under this gravity: ω0 is the root of gravity over length, and all rods have
    /// this length. The default length is one metre, the default gravity 9.80665 m/s².
    ///
    /// # Errors
    /// Parameters that do not determine the length or the gravity, as for a body that is not a mass on a rod.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::systems::NamedSystem;
    /// let pendulum = NamedSystem::by_key("pendulum")?;
    /// let [(name, value)] = &pendulum.values_of(Some(4.0), Some(9.0))?[..] else { panic!() };
    /// assert_eq!((*name, value.to_f64()), ("omega0", Some(1.5)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn values_of(
        &self,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> Result<Vec<(&'static str, Expression)>, PendulumParametersError> {
        /// The pendulum of a metre under the standard gravity.
        const DEFAULTS: [f64; 2] = [1.0, STANDARD_GRAVITY];
        let number = |value: f64| decimal(value).ok_or(PendulumParametersError::NotAbove(value));
        let quotient = Expression::Divide(
            Box::new(number(gravity.unwrap_or(DEFAULTS[1]))?),
            Box::new(number(length.unwrap_or(DEFAULTS[0]))?),
        );
        let frequency = Expression::Call(Function::Sqrt, Box::new(quotient));
        let mut values = vec![];
        let mut said = [length.is_none(), gravity.is_none()];
        for parameter in self.parameters {
            let (value, says) = match (parameter.name, length, gravity) {
                ("omega0" | "omega1" | "omega2", ..) => (frequency.clone(), [true, true]),
                ("l" | "l1" | "l2", Some(length), _) => (number(length)?, [true, false]),
                ("g", ..) => (number(gravity.unwrap_or(DEFAULTS[1]))?, [false, true]),
                _ => continue,
            };
            values.push((parameter.name, value));
            said = [said[0] || says[0], said[1] || says[1]];
        }
        let names = || self.parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>().join(", ");
        match said {
            [true, true] => Ok(values),
            [false, _] => {
                Err(PendulumParametersError::Without { key: self.key, what: "length", parameters: names() })
            }
            [_, false] => {
                Err(PendulumParametersError::Without { key: self.key, what: "gravity", parameters: names() })
            }
        }
    }
}

/// The reason why a system is not a pendulum of a given length or gravity.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PendulumParametersError {
    /// A length or gravity that is not above zero.
    #[error("the length or gravity is {0:?}: give finite numbers above zero")]
    NotAbove(f64),
    /// Parameters that do not determine the length or the gravity.
    #[error("{key} has no {what} among its parameters, which are {parameters}: give these")]
    Without {
        /// The system.
        key: &'static str,
        /// The requested quantity.
        what: &'static str,
        /// The parameters of the system.
        parameters: String,
    },
}

/// A positive number as the decimal with which it is printed.
fn decimal(value: f64) -> Option<Expression> {
    let above = Some(value).filter(|value| value.is_finite() && *value > 0.0);
    above.and_then(|value| format!("{value:?}").parse().ok())
}
