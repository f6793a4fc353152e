//! The state a motion begins in, by names: `theta=60deg,theta'=0`.

use super::values::plain_name;
use crate::failure::Failure;
use libration::expression::{Expression, Symbol};
use libration::quantity::{Angle, Dimension, parse};
use libration::systems::Model;

/// The option that says where a motion begins.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct InitialOptions {
    /// Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33) for all of a chain; those not given start
    /// at rest
    #[arg(long, value_name = "NAME=VALUE,…")]
    initial: Option<String>,
}

/// The state at the start.
#[derive(Clone, Debug)]
pub(crate) struct Initial {
    /// Coordinates, then velocities.
    pub(crate) state: Vec<f64>,
    /// Names and values of the numbers that were not given and are those of rest.
    pub(crate) assumed: Vec<(String, f64)>,
}

impl InitialOptions {
    /// Whether it was given at all.
    pub(crate) fn is_given(&self) -> bool {
        self.initial.is_some()
    }

    /// The state of the model that is meant.
    pub(crate) fn read(&self, model: &Model) -> Result<Initial, Failure> {
        let text = self.initial.as_deref().ok_or_else(|| missing(model))?;
        Initial::read(text, model)
    }

    /// The state with further names and values, which have reasons of their own not to be one.
    pub(crate) fn read_with(
        &self,
        values: &[(&str, &str)],
        model: &Model,
    ) -> Result<Result<Initial, String>, Failure> {
        let own = self.initial.as_deref().map_or(Ok(vec![]), |text| items(text, model))?;
        say_bare_angles(&own, model);
        // What is wrong with the option is not the fault of the others.
        Initial::of_values(&own, model).map_err(usage)?;
        match own.is_empty() && values.is_empty() {
            true => Err(missing(model)),
            false => Ok(Initial::of_values(&[&own, values].concat(), model)),
        }
    }
}

/// The option that says where several motions begin.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct SeveralInitialOptions {
    /// Coordinates and velocities at the start, such as theta=60deg,theta'=0; those not given start at rest; give it several
    /// times for several motions
    #[arg(long, value_name = "NAME=VALUE,…")]
    initial: Vec<String>,
}

impl SeveralInitialOptions {
    /// The states that are meant; at least one.
    pub(crate) fn read(&self, model: &Model) -> Result<Vec<Initial>, Failure> {
        if self.initial.is_empty() {
            return Err(missing(model));
        }
        self.initial.iter().map(|text| Initial::read(text, model)).collect()
    }
}

impl Initial {
    fn read(text: &str, model: &Model) -> Result<Self, Failure> {
        let items = items(text, model)?;
        say_bare_angles(&items, model);
        Self::of_values(&items, model).map_err(usage)
    }

    /// From names and values.
    fn of_values(values: &[(&str, &str)], model: &Model) -> Result<Self, String> {
        let (names, units) = (model.state_names(), model.state_units());
        let mut given: Vec<Option<f64>> = vec![None; names.len()];
        for (name, value) in values {
            let values = match Family::of(name) {
                Some(family) => family.values(value, &names)?,
                None => {
                    let place = place_of(name, &names)?;
                    vec![(place, number(&names[place], value, &units[place])?)]
                }
            };
            for (place, value) in values {
                if given[place].is_some() {
                    return Err(format!("{} is given twice: give it one value", names[place]));
                }
                given[place] = Some(value);
            }
        }
        let rest = model.state_at_rest();
        let omitted = given.iter().enumerate().filter(|(_, value)| value.is_none());
        let assumed = omitted.map(|(place, _)| (names[place].clone(), rest[place])).collect();
        let state = given.iter().zip(&rest).map(|(value, rest)| value.unwrap_or(*rest)).collect();
        Ok(Self { state, assumed })
    }
}

/// The names and values in a text.
fn items<'a>(text: &'a str, model: &Model) -> Result<Vec<(&'a str, &'a str)>, Failure> {
    let item = |item: &'a str| {
        item.split_once('=').ok_or_else(|| {
            let example = &model.state_names()[0];
            usage(format!("`{}` has no value: give NAME=VALUE, such as {example}=0.5", item.trim()))
        })
    };
    text.split(',').filter(|item| !item.trim().is_empty()).map(item).collect()
}

/// Says how angles without a unit are understood where that may surprise.
fn say_bare_angles(items: &[(&str, &str)], model: &Model) {
    let (names, units) = (model.state_names(), model.state_units());
    for (name, value) in items {
        if place_of(name, &names).is_ok_and(|place| units[place] == "rad") {
            super::bare::say(value);
        }
    }
}

fn usage(reason: impl std::fmt::Display) -> Failure {
    Failure::usage("--initial", reason)
}

fn missing(model: &Model) -> Failure {
    let example = |coordinate: &libration::systems::Coordinate| match coordinate.is_angle() {
        true => format!("{}=60deg", coordinate.name),
        false => format!("{}=0.5", coordinate.name),
    };
    let examples: Vec<String> = model.coordinates().iter().map(example).collect();
    usage(format!(
        "the initial state is missing: give it, such as --initial \"{}\"; the state variables are {}",
        examples.join(","),
        model.state_names().join(", ")
    ))
}

fn place_of(name: &str, names: &[String]) -> Result<usize, String> {
    let plain = plain_name(name);
    names.iter().position(|known| *known == plain).ok_or_else(|| {
        format!("the system has no state variable `{}`: it has {}", name.trim(), names.join(", "))
    })
}

/// Many numbers of a state at once: `x[i]`, or `x[i]'`.
struct Family<'a> {
    name: &'a str,
    letter: &'a str,
    primes: &'a str,
}

impl<'a> Family<'a> {
    /// `None` for one number, as `x[3]` is.
    fn of(name: &'a str) -> Option<Self> {
        let (name, rest) = name.trim().split_once('[')?;
        let (letter, primes) = rest.split_once(']')?;
        let is_letter = letter.chars().all(|c| c.is_ascii_alphabetic()) && !letter.is_empty();
        is_letter.then_some(Self { name, letter, primes })
    }

    /// The places of all members, and the values of a formula of the index.
    fn values(&self, text: &str, names: &[String]) -> Result<Vec<(usize, f64)>, String> {
        let index = |known: &str| {
            known.strip_prefix(self.name)?.strip_suffix(self.primes)?.parse::<u32>().ok().map(i64::from)
        };
        let places = names.iter().enumerate().filter_map(|(place, known)| Some((place, index(known)?)));
        let places: Vec<(usize, i64)> = places.collect();
        let shown = format!("{}[{}]{}", self.name, self.letter, self.primes);
        if places.is_empty() {
            return Err(format!("the system has no state variables {shown}: it has {}", names.join(", ")));
        }
        let formula: Expression = text.parse().map_err(|error| format!("{shown}: {error}"))?;
        let letter = Symbol::plain(self.letter);
        let value = |(place, index): (usize, i64)| {
            let value = formula.substitute(&letter, &Expression::from(index)).to_f64();
            let value = value.filter(|value| value.is_finite()).ok_or_else(|| {
                format!(
                    "{shown}: `{text}` has no value at {} = {index}: give a formula of {}, such as sin(pi*{}/33)",
                    self.letter, self.letter, self.letter
                )
            });
            Ok((place, value?))
        };
        places.into_iter().map(value).collect()
    }
}

/// A quantity in the unit of its number, or a formula of numbers.
fn number(name: &str, text: &str, unit: &str) -> Result<f64, String> {
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
    value.or_else(|reason| formula().ok_or(reason)).map_err(|reason| format!("{name}: {reason}"))
}
