//! Formulas with names, `energy = x'^2/2 - cos(x), p = 2*x'`.

use super::commas::at_commas;
use crate::query_error::{Parameter, QueryError};
use libration::expression::Expression;
use libration::systems::{Model, Observables};

/// The formulas of an option; those without a name are named by their text.
pub(crate) fn columns(argument: &Parameter, text: &str, model: &Model) -> Result<Observables, QueryError> {
    let usage = |reason: String| QueryError::usage(argument, reason);
    let mut formulas: Vec<(&str, Expression)> = vec![];
    for item in at_commas(text) {
        let (name, formula) = item.split_once('=').unwrap_or((item, item));
        let (name, formula) = (name.trim(), formula.trim());
        if name.is_empty() || formula.is_empty() {
            let given = item.trim();
            return Err(usage(format!(
                "`{given}` is not a formula: give NAME = FORMULA, such as energy = x'^2/2"
            )));
        }
        let formula = formula.parse().map_err(|error| usage(format!("{name}: {error}")))?;
        formulas.push((name, formula));
    }
    Observables::new(model, &formulas).map_err(|error| usage(error.to_string()))
}
