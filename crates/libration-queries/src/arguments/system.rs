//! Choice of a system: a key of a catalogue or equations of motion, with values for their parameters.

use super::names::EquationText;
use super::reading;
use super::text::{gravity, length};
use super::values::{borrowed, values};
use crate::query_error::{Parameter, QueryError, argument, option};
use libration::catalogue::is_like_a_key;
use libration::expression::{EquationError, Expression};
use libration::systems::{Model, ModelError, NamedSystem, PendulumParametersError};
use std::fmt::Display;

/// The system.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct SystemOptions {
    /// A key from `libration list`, or equations of motion, such as "x'' = y - x; y'' = x - y", or of the first order, such as "x' = x - x*y; y' = x*y - y"
    #[arg(value_name = "SYSTEM|EQUATION")]
    system: EquationText,
    /// The value of a parameter: a number, or a formula such as 1/2; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
}

/// Options for a system that may be a pendulum with a length and gravity.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct PendulumSystemOptions {
    #[command(flatten)]
    system: SystemOptions,
    /// Length of the rods of a named pendulum, such as 1m or 57cm [default: see `libration list`]
    #[arg(long, value_parser = length)]
    length: Option<f64>,
    /// Acceleration of free fall of a named pendulum, such as 9.81m/s^2
    #[arg(long, value_parser = gravity)]
    gravity: Option<f64>,
}

/// A system as far as its options are given.
#[derive(Clone, Debug)]
pub(crate) struct GivenSystem<'a> {
    options: &'a SystemOptions,
    values: Vec<(String, Expression)>,
    /// The system with these values, and defaults.
    model: Model,
}

impl SystemOptions {
    /// The model with a value for each parameter.
    pub(crate) fn model(&self) -> Result<Model, QueryError> {
        self.model_with_open(&[], &option("set"))
    }

    /// The model with these parameters left open.
    pub(crate) fn model_with_open(&self, open: &[&str], giver: &Parameter) -> Result<Model, QueryError> {
        self.model_with(&values(&self.set)?, open, Varied { names: open, giver })
    }

    /// The model, whose parameters may remain symbolic.
    pub(crate) fn model_with_letters(&self) -> Result<Model, QueryError> {
        let model = self.incomplete_model(&values(&self.set)?, &[]);
        model.map_err(|error| failure(error, Varied { names: &[], giver: &option("set") }))
    }

    /// The numbers of a state, whatever has no value yet.
    pub(crate) fn state_names(&self) -> Result<Vec<String>, QueryError> {
        Ok(self.model_with_letters()?.state_names())
    }

    /// The model with these values and open parameters, one of which is varied by `--over`.
    fn model_with(
        &self,
        values: &[(String, Expression)],
        open: &[&str],
        varied: Varied<'_>,
    ) -> Result<Model, QueryError> {
        let model = self.incomplete_model(values, open).map_err(|error| failure(error, varied))?;
        match model.open_parameters().into_iter().find(|name| !open.contains(&name.as_str())) {
            Some(name) => Err(QueryError::usage(
                option("set"),
                format!("`{name}` has no value: give it one, such as <--set={name}=0.1>"),
            )),
            None => Ok(model),
        }
    }

    /// The same, whatever else has no value.
    fn incomplete_model(&self, values: &[(String, Expression)], open: &[&str]) -> Result<Model, ModelError> {
        let (name, values) = (self.system.trim(), borrowed(values));
        match is_like_a_key(name) {
            true => Model::by_key(name, &values, open),
            false => {
                reading::say(name);
                Model::typed(name, &values, open)
            }
        }
    }
}

impl PendulumSystemOptions {
    /// The model with a value for each parameter.
    pub(crate) fn model(&self) -> Result<Model, QueryError> {
        self.model_over(None)
    }

    /// The model with one more parameter that has a value.
    pub(crate) fn model_over(&self, parameter: Option<(&str, f64)>) -> Result<Model, QueryError> {
        let names: Vec<_> = parameter.iter().map(|named| named.0).collect();
        let varied = Varied { names: &names, giver: &option("over") };
        self.system.model_with(&self.values(parameter)?, &[], varied)
    }

    /// The options of a system that gets values from elsewhere, too.
    pub(crate) fn given(&self) -> Result<GivenSystem<'_>, QueryError> {
        let model = self.system.incomplete_model(&self.values(None)?, &[]);
        let model = model.map_err(|error| failure(error, Varied { names: &[], giver: &option("set") }))?;
        Ok(GivenSystem { options: &self.system, values: self.values(None)?, model })
    }

    /// The values that options give to parameters.
    fn values(&self, parameter: Option<(&str, f64)>) -> Result<Vec<(String, Expression)>, QueryError> {
        let mut values = values(&self.system.set)?;
        if let Some((name, value)) = parameter {
            let value =
                format!("{value:?}").parse().map_err(|error| QueryError::usage(option("over"), error))?;
            values.push((name.to_owned(), value));
        }
        let argument = if self.length.is_some() { option("length") } else { option("gravity") };
        let apparatus = self.apparatus(&argument)?;
        if let Some((name, _)) =
            apparatus.iter().find(|(name, _)| values.iter().any(|value| value.0 == *name))
        {
            let other = if parameter.is_some_and(|parameter| parameter.0 == *name) {
                option("over")
            } else {
                option("set")
            };
            let reason = format!("it sets {name}, as {other} does: give one of them");
            return Err(QueryError::usage(argument, reason));
        }
        values.extend(apparatus.into_iter().map(|(name, value)| (name.to_owned(), value)));
        Ok(values)
    }

    /// The values of parameters that follow from length and gravity, where these are given; `argument` is the option for errors.
    fn apparatus(&self, argument: &Parameter) -> Result<Vec<(&'static str, Expression)>, QueryError> {
        if self.length.is_none() && self.gravity.is_none() {
            return Ok(vec![]);
        }
        let named = NamedSystem::by_key(self.system.system.trim()).map_err(|_| {
            let reason = "only the pendulums of <libration list> accept it, such as damped_pendulum";
            QueryError::usage(argument, reason)
        })?;
        named.values_of(self.length, self.gravity).map_err(|error| match error {
            PendulumParametersError::Without { .. } => {
                QueryError::usage(argument, format!("{error} by <--set>"))
            }
            _ => QueryError::usage(argument, error),
        })
    }
}

impl GivenSystem<'_> {
    /// The numbers of its state.
    pub(crate) fn state_names(&self) -> Vec<String> {
        self.model.state_names()
    }

    /// The state components that are angles.
    pub(crate) fn angles(&self) -> Vec<String> {
        let names = self.model.state_names().into_iter().zip(self.model.state_units());
        names.filter(|(_, unit)| unit == "rad").map(|(name, _)| name).collect()
    }

    /// Returns `true` if a parameter is the number of coordinates.
    pub(crate) fn counts(&self, parameter: &str) -> bool {
        let named = NamedSystem::by_key(self.options.system.trim());
        named.is_ok_and(|named| named.count == Some(parameter))
    }

    /// The parameters that no option gives a value, those with default values before the others.
    pub(crate) fn free_parameters(&self) -> Vec<String> {
        let with_default = self.model.values().iter().map(|(name, _)| name.clone());
        let free = with_default.filter(|name| !self.gives(name) && !self.counts(name));
        free.chain(self.model.open_parameters()).collect()
    }

    /// Returns `true` if an option gives the parameter a value.
    pub(crate) fn gives(&self, parameter: &str) -> bool {
        self.values.iter().any(|(name, _)| name == parameter)
    }

    /// The model with further values.
    pub(crate) fn model_with(&self, values: &[(String, Expression)]) -> Result<Model, ModelError> {
        self.options.incomplete_model(&[&self.values, values].concat(), &[])
    }

    /// The model with these parameters open, whatever values the options give them.
    pub(crate) fn model_with_open(&self, open: &[&str], giver: &Parameter) -> Result<Model, QueryError> {
        let others = self.values.iter().filter(|(name, _)| !open.contains(&name.as_str()));
        self.options.model_with(&others.cloned().collect::<Vec<_>>(), open, Varied { names: open, giver })
    }
}

/// Parameters that an option other than `--set` gives values to.
#[derive(Clone, Copy)]
struct Varied<'a> {
    names: &'a [&'a str],
    giver: &'a Parameter,
}

/// The error with its option: the one that gave the parameter, or the system itself.
fn failure(error: ModelError, varied: Varied<'_>) -> QueryError {
    let parameter = match &error {
        ModelError::Equation(
            EquationError::UnknownParameter { name, .. }
            | EquationError::SetTwice(name)
            | EquationError::NotConstant { name, .. },
        ) => Some(name.as_str()),
        _ => None,
    };
    let about = match (parameter, &error) {
        (Some(name), _) if varied.names.contains(&name) => varied.giver.clone(),
        (Some(_), _) | (_, ModelError::Equation(EquationError::DropsOut(_))) => option("set"),
        _ => argument("SYSTEM|EQUATION"),
    };
    QueryError::usage(about, &error).with_item(parameter)
}

/// Adds a zero drive amplitude of the system to the reason why there is no motion.
pub(crate) fn with_idle_drive(reason: impl Display, model: &Model) -> String {
    match &model.idle_drives()[..] {
        [] => reason.to_string(),
        [name, ..] => {
            format!(
                "nothing drives the system, since {name} = 0: give a drive, such as <--set={name}=0.1>; without one {reason}"
            )
        }
    }
}
