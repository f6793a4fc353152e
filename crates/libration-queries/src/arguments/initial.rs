//! The state a motion begins in, by names: `theta=60deg,theta'=0`.

use super::commas::at_commas;
use crate::call;
use crate::query_error::{QueryError, option};
use libration::quantity::RoundedComplement;
use libration::systems::{InitialState, Model};

/// Option for the initial state of a motion.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct InitialOptions {
    /// Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33) for all of a chain; those not given start
    /// at rest
    #[arg(long, value_name = "NAME=VALUE,…")]
    initial: Option<String>,
}

/// The purpose for which a state is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Meant {
    /// A state that may be at rest, whose equilibrium is analysed.
    Rest,
    /// Initial state of a motion.
    Motion,
}

/// The state at the start.
#[derive(Clone, Debug)]
pub(crate) struct Initial {
    /// Coordinates, then velocities.
    pub(crate) state: Vec<f64>,
    /// Names and values of the components that were not given and have their values at rest.
    pub(crate) assumed: Vec<(String, f64)>,
}

impl InitialOptions {
    /// Returns `true` if the state was given.
    pub(crate) fn is_given(&self) -> bool {
        self.initial.is_some()
    }

    /// The state of the model that a motion begins in.
    pub(crate) fn read(&self, model: &Model) -> Result<Initial, QueryError> {
        let text = self.initial.as_deref().ok_or_else(|| missing(model))?;
        Initial::read(text, model, Meant::Motion)
    }

    /// The requested state of the model, perhaps a state at rest.
    pub(crate) fn read_at_rest(&self, model: &Model) -> Result<Initial, QueryError> {
        let text = self.initial.as_deref().ok_or_else(|| missing(model))?;
        Initial::read(text, model, Meant::Rest)
    }

    /// The guess with which a search for motions begins: the given state, or that of rest; `None` if this is not known to be other than zero.
    pub(crate) fn guess(&self, model: &Model) -> Result<Option<Vec<f64>>, QueryError> {
        let given = self.is_given().then(|| self.read_at_rest(model)).transpose()?;
        let at_rest = || Some(model.state_at_rest()).filter(|state| state.iter().any(|x| *x != 0.0));
        Ok(given.map(|initial| initial.state).or_else(at_rest))
    }

    /// The state with further names and values, each of which may be refused with a reason.
    pub(crate) fn read_with(
        &self,
        values: &[(&str, &str)],
        model: &Model,
    ) -> Result<Result<Initial, String>, QueryError> {
        let given = self.initial.as_deref().map_or(Ok(vec![]), |text| items(text, model))?;
        say_of_angles(&given, model, Meant::Motion);
        // What is wrong with the option is not the fault of the others.
        Initial::of_values(&given, model).map_err(usage)?;
        match given.is_empty() && values.is_empty() {
            true => Err(missing(model)),
            false => Ok(Initial::of_values(&[&given, values].concat(), model)),
        }
    }
}

/// Option for the initial states of several motions.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct SeveralInitialOptions {
    /// Coordinates and velocities at the start, such as theta=60deg,theta'=0; those not given start at rest; repeat the option for
    /// several motions
    #[arg(long, value_name = "NAME=VALUE,…")]
    initial: Vec<String>,
}

impl SeveralInitialOptions {
    /// The requested states; at least one.
    pub(crate) fn read(&self, model: &Model) -> Result<Vec<Initial>, QueryError> {
        if self.initial.is_empty() {
            return Err(missing(model));
        }
        self.initial.iter().map(|text| Initial::read(text, model, Meant::Motion)).collect()
    }
}

impl Initial {
    fn read(text: &str, model: &Model, meant: Meant) -> Result<Self, QueryError> {
        let items = items(text, model)?;
        say_of_angles(&items, model, meant);
        Self::of_values(&items, model).map_err(usage)
    }

    /// The state from names and values.
    fn of_values(values: &[(&str, &str)], model: &Model) -> Result<Self, String> {
        let InitialState { state, assumed } = model.initial(values).map_err(|error| error.to_string())?;
        Ok(Self { state, assumed })
    }
}

/// The names and values in a text.
fn items<'a>(text: &'a str, model: &Model) -> Result<Vec<(&'a str, &'a str)>, QueryError> {
    let item = |item: &'a str| {
        item.split_once('=').ok_or_else(|| {
            let example = &model.state_names()[0];
            usage(format!("`{}` has no value: give NAME=VALUE, such as {example}=0.5", item.trim()))
        })
    };
    at_commas(text).into_iter().filter(|item| !item.trim().is_empty()).map(item).collect()
}

/// Writes notes on angles without a unit, and on the digits that angles next to the upright position lose.
fn say_of_angles(items: &[(&str, &str)], model: &Model, meant: Meant) {
    for (_, value) in items.iter().filter(|(name, _)| model.is_angle(name)) {
        super::bare::say(value);
        let lost = value.parse().ok().as_ref().and_then(RoundedComplement::of);
        // An answer about the upright state of rest is not another one for the last digit of pi; a motion that begins there falls.
        if let Some(lost) = lost.filter(|lost| lost.wanted > 0.0 || meant == Meant::Motion) {
            call::current().note(&format!("{}: {lost}", value.trim()));
        }
    }
}

fn usage(reason: impl std::fmt::Display) -> QueryError {
    QueryError::usage(option("initial"), reason)
}

fn missing(model: &Model) -> QueryError {
    let example = |coordinate: &libration::systems::Coordinate| match coordinate.is_angle() {
        true => format!("{}=60deg", coordinate.name),
        false => format!("{}=0.5", coordinate.name),
    };
    let examples: Vec<String> = model.coordinates().iter().map(example).collect();
    usage(format!(
        "the initial state is missing: give it, such as <--initial={}>; the state variables are {}",
        examples.join(","),
        model.state_names().join(", ")
    ))
}
