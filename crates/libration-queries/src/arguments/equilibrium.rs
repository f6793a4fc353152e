//! Choice of an equilibrium: `theta=180deg`.

use super::commas::at_commas;
use super::{coordinate, say_radians};
use crate::query_error::{QueryError, option};
use libration::expression::Expression;
use libration::quantity::Angle;
use libration::systems::{Coordinate, Model};

#[derive(Clone, Debug, clap::Args)]
pub(crate) struct EquilibriumOptions {
    /// Coordinates near the equilibrium, such as x=1,theta=180deg; the others are taken at rest
    #[arg(long, value_name = "NAME=VALUE,…")]
    about: Option<String>,
}

impl EquilibriumOptions {
    /// Returns `true` if coordinates are given.
    pub(crate) const fn is_given(&self) -> bool {
        self.about.is_some()
    }

    /// The given coordinates; the others have their equilibrium values.
    pub(crate) fn guess(&self, model: &Model) -> Result<Vec<f64>, QueryError> {
        let mut guess: Vec<f64> = model.coordinates().iter().map(|coordinate| coordinate.at_rest).collect();
        let about = self.about.as_deref().unwrap_or_default();
        for item in at_commas(about).into_iter().filter(|item| !item.trim().is_empty()) {
            let (name, value) = item.split_once('=').ok_or_else(|| {
                refusal(format!("`{}` has no value: give NAME=VALUE, such as x=1", item.trim()))
            })?;
            let index = coordinate(model, &option("about"), name)?;
            guess[index] = number(&model.coordinates()[index], value.trim())?;
        }
        Ok(guess)
    }
}

fn refusal(reason: String) -> QueryError {
    QueryError::usage(option("about"), reason)
}

fn number(coordinate: &Coordinate, text: &str) -> Result<f64, QueryError> {
    let formula = || text.parse::<Expression>().ok()?.to_f64().filter(|value| value.is_finite());
    let angle = || text.parse::<Angle>().ok().filter(|_| coordinate.is_angle()).map(|angle| angle.radians());
    if coordinate.is_angle() {
        say_radians(text);
    }
    formula().or_else(angle).ok_or_else(|| {
        refusal(format!(
            "{}: `{text}` is not a number: write 0.5, sqrt(2)/2, or 90deg for an angle",
            coordinate.name
        ))
    })
}
