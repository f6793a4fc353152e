//! The initial state of a motion, from names and values as text: `theta` and `60deg`.

use super::Model;
use super::model::plain;
use libration_numbers::expression::{Expression, Symbol};
use libration_numbers::quantity::{Angle, Dimension, parse};

/// The state at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct InitialState {
    /// Coordinates, then velocities.
    pub state: Vec<f64>,
    /// Names and values of the components that were not given and have their values at rest.
    pub assumed: Vec<(String, f64)>,
}

/// The reason why names and values do not form a state.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InitialStateError {
    /// A name that is not a state variable.
    #[error("the system has no state variable `{name}`: it has {}", known.join(", "))]
    Unknown {
        /// The requested name.
        name: String,
        /// The names of all state variables.
        known: Vec<String>,
    },
    /// A name with an index that is not a state variable.
    #[error("the system has no state variables {name}: it has {}", known.join(", "))]
    NoFamily {
        /// The requested name, such as `x[i]`.
        name: String,
        /// The names of all state variables.
        known: Vec<String>,
    },
    /// Two values for one component.
    #[error("{0} is given twice: give it one value")]
    Twice(String),
    /// A value that could not be parsed.
    #[error("{name}: {reason}")]
    Value {
        /// The name of the variable.
        name: String,
        /// The reason.
        reason: String,
    },
}

impl Model {
    /// The state from names and values: numbers, formulas of numbers, quantities in the unit of the component, angles; for all members of a
    /// chain a formula of the index. Components that are not given are at rest.
    ///
    /// # Errors
    /// Names that are not state variables, two values for one component, a value that could not be parsed.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_motion as libration;
    /// use libration::systems::Model;
    /// let model = Model::by_key("pendulum", &[], &[])?;
    /// let start = model.initial(&[("theta", "90deg"), ("theta'", "2 rad/s")])?;
    /// assert_eq!(start.state, [std::f64::consts::FRAC_PI_2, 2.0]);
    /// let chain = Model::typed("x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..3; x[0] = 0; x[4] = 0", &[], &[])?;
    /// assert_eq!(chain.initial(&[("x[i]", "i/2")])?.state, [0.5, 1.0, 1.5, 0.0, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn initial(&self, values: &[(&str, &str)]) -> Result<InitialState, InitialStateError> {
        let (names, units) = (self.state_names(), self.state_units());
        let mut given: Vec<Option<f64>> = vec![None; names.len()];
        for (name, value) in values {
            let values = match IndexedComponents::of(name) {
                Some(family) => family.values(value, &names)?,
                None => {
                    let index = place_of(name, &names)?;
                    vec![(index, number(&names[index], value, &units[index])?)]
                }
            };
            for (index, value) in values {
                if given[index].is_some() {
                    return Err(InitialStateError::Twice(names[index].clone()));
                }
                given[index] = Some(value);
            }
        }
        let rest = self.state_at_rest();
        let omitted = given.iter().enumerate().filter(|(_, value)| value.is_none());
        let assumed = omitted.map(|(index, _)| (names[index].clone(), rest[index])).collect();
        let state = given.iter().zip(&rest).map(|(value, rest)| value.unwrap_or(*rest)).collect();
        Ok(InitialState { state, assumed })
    }

    /// Returns `true` if the state variable of this name is an angle.
    #[must_use]
    pub fn is_angle(&self, name: &str) -> bool {
        place_of(name, &self.state_names()).is_ok_and(|index| self.state_units()[index] == "rad")
    }
}

fn place_of(name: &str, names: &[String]) -> Result<usize, InitialStateError> {
    let plain = plain(name.trim());
    let unknown = || InitialStateError::Unknown { name: name.trim().to_owned(), known: names.to_vec() };
    names.iter().position(|listed| *listed == plain).ok_or_else(unknown)
}

/// Several components of a state at once: `x[i]`, or `x[i]'`.
struct IndexedComponents<'a> {
    name: &'a str,
    letter: &'a str,
    primes: &'a str,
}

impl<'a> IndexedComponents<'a> {
    /// The family of a name; `None` for a single component such as `x[3]`.
    fn of(name: &'a str) -> Option<Self> {
        let (name, rest) = name.trim().split_once('[')?;
        let (letter, primes) = rest.split_once(']')?;
        let is_letter = letter.chars().all(|c| c.is_ascii_alphabetic()) && !letter.is_empty();
        is_letter.then_some(Self { name, letter, primes })
    }

    /// The indices of all members, and the values of a formula of the index.
    fn values(&self, text: &str, names: &[String]) -> Result<Vec<(usize, f64)>, InitialStateError> {
        let index = |member: &str| {
            member.strip_prefix(self.name)?.strip_suffix(self.primes)?.parse::<u32>().ok().map(i64::from)
        };
        let numbered = names.iter().enumerate().filter_map(|(at, member)| Some((at, index(member)?)));
        let members: Vec<(usize, i64)> = numbered.collect();
        let name = format!("{}[{}]{}", self.name, self.letter, self.primes);
        if members.is_empty() {
            return Err(InitialStateError::NoFamily { name, known: names.to_vec() });
        }
        let wrong = |reason: String| InitialStateError::Value { name: name.clone(), reason };
        let formula: Expression = text.parse().map_err(|error| wrong(format!("{error}")))?;
        let letter = Symbol::plain(self.letter);
        let value = |(at, index): (usize, i64)| {
            let value = formula.substitute(&letter, &Expression::from(index)).to_f64();
            let value = value.filter(|value| value.is_finite()).ok_or_else(|| {
                wrong(format!(
                    "`{text}` has no value at {} = {index}: give a formula of {}, such as sin(pi*{}/33)",
                    self.letter, self.letter, self.letter
                ))
            });
            Ok((at, value?))
        };
        members.into_iter().map(value).collect()
    }
}

/// A quantity in the unit of its component, or a formula of numbers.
fn number(name: &str, text: &str, unit: &str) -> Result<f64, InitialStateError> {
    let text = text.trim();
    let formula = || text.parse::<Expression>().ok()?.to_f64().filter(|value| value.is_finite());
    let quantity = |dimension| Ok(parse(text, dimension).map_err(|error| error.to_string())?.value);
    let value = match unit {
        "rad" => text.parse::<Angle>().map(|angle| angle.radians()).map_err(|error| error.to_string()),
        "rad/s" => quantity(Dimension::AngularVelocity),
        "m" => quantity(Dimension::Length),
        "m/s" => quantity(Dimension::Velocity),
        _ => Err(format!(
            "cannot read `{text}` as a number: write 0.5, 1e-3 or sqrt(2)/2; units are for angles and lengths"
        )),
    };
    let wrong = |reason| InitialStateError::Value { name: name.to_owned(), reason };
    value.or_else(|reason| formula().ok_or(reason)).map_err(wrong)
}
