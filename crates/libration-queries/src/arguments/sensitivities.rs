//! Variables with respect to which a motion is differentiated: names of parameters and of initial values.

use super::system::GivenSystem;
use super::values::plain_name;
use crate::query_error::{QueryError, option};
use libration::expression::Expression;
use libration::systems::Model;
use libration::taylor::Sensitivities;

/// The sensitivities of the motions of a model to the named variables; `None` if there are no names.
pub(crate) fn sensitivities(
    names: &[String],
    system: &GivenSystem<'_>,
    model: &Model,
) -> Result<Option<Sensitivities>, QueryError> {
    let usage = |reason: String| QueryError::usage(option("sensitivity"), reason);
    if names.is_empty() {
        return Ok(None);
    }
    let names: Vec<String> = names.iter().map(|name| plain_name(name)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let values = model.values().iter().filter(|(name, _)| !system.counts(name));
    let values: Vec<(&str, Expression)> =
        values.map(|(name, value)| (name.as_str(), value.clone())).collect();
    let open = system
        .model_with_open(&values.iter().map(|(name, _)| *name).collect::<Vec<_>>(), &option("sensitivity"))?;
    Sensitivities::new(open.equation(), &values, &names).map(Some).map_err(|error| usage(error.to_string()))
}
