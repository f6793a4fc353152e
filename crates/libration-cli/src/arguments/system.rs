//! Which system is meant: a key of a catalogue or equations of motion, with values for their parameters.

use super::values::{borrowed, is_like_a_key, values};
use crate::failure::Failure;
use libration::expression::{EquationError, Expression};
use libration::systems::{Model, ModelError, NamedSystem};

/// The system asked about.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct SystemOptions {
    /// A key from `libration systems` or `libration oscillators`, or equations of motion, such as "x'' = y - x; y'' = x - y"
    #[arg(value_name = "SYSTEM|EQUATION")]
    system: String,
    /// The value of a parameter: a number, or a formula such as 1/2; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
}

impl SystemOptions {
    /// The model with a value for each parameter.
    pub(crate) fn model(&self) -> Result<Model, Failure> {
        self.model_with_open(&[])
    }

    /// The model of a pendulum of this length under this gravity, where they are given.
    pub(crate) fn model_of(&self, length: Option<f64>, gravity: Option<f64>) -> Result<Model, Failure> {
        self.model_over(length, gravity, None)
    }

    /// The same with one more parameter that has a value.
    pub(crate) fn model_over(
        &self,
        length: Option<f64>,
        gravity: Option<f64>,
        parameter: Option<(&str, f64)>,
    ) -> Result<Model, Failure> {
        let mut values = values(&self.set)?;
        if let Some((name, value)) = parameter {
            let value = format!("{value:?}").parse().map_err(|error| Failure::usage("--over", error))?;
            values.push((name.to_owned(), value));
        }
        if length.is_none() && gravity.is_none() {
            return self.model_with(&values, &[]);
        }
        let argument = if length.is_some() { "--length" } else { "--gravity" };
        let named = NamedSystem::by_key(self.system.trim()).map_err(|_| {
            let reason = "only the pendulums of `libration systems` take it, such as damped_pendulum";
            Failure::usage(argument, reason)
        })?;
        let of_pendulum =
            named.values_of(length, gravity).map_err(|reason| Failure::usage(argument, reason))?;
        if let Some((name, _)) = of_pendulum.iter().find(|(name, _)| values.iter().any(|it| it.0 == *name)) {
            let reason = format!("it sets {name}, as --set does: give one of them");
            return Err(Failure::usage(argument, reason));
        }
        values.extend(of_pendulum.into_iter().map(|(name, value)| (name.to_owned(), value)));
        self.model_with(&values, &[])
    }

    /// The model with these parameters left open.
    pub(crate) fn model_with_open(&self, open: &[&str]) -> Result<Model, Failure> {
        self.model_with(&values(&self.set)?, open)
    }

    fn model_with(&self, values: &[(String, Expression)], open: &[&str]) -> Result<Model, Failure> {
        let (name, values) = (self.system.trim(), borrowed(values));
        let model = match is_like_a_key(name) {
            true => Model::by_key(name, &values, open),
            false => Model::typed(name, &values, open),
        };
        let model = model.map_err(failure)?;
        match model.open_parameters().into_iter().find(|name| !open.contains(&name.as_str())) {
            Some(name) => Err(Failure::usage(
                "--set",
                format!("`{name}` has no value: give it one, such as --set {name}=0.1"),
            )),
            None => Ok(model),
        }
    }
}

fn failure(error: ModelError) -> Failure {
    let argument = match &error {
        ModelError::Equation(
            EquationError::UnknownParameter { .. }
            | EquationError::SetTwice(_)
            | EquationError::NotConstant { .. }
            | EquationError::DropsOut(_),
        ) => "--set",
        _ => "SYSTEM|EQUATION",
    };
    Failure::usage(argument, error)
}
