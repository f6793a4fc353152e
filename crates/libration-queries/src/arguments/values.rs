//! Values of parameters, `--set c=0.1`.

use super::commas::at_commas;
use crate::query_error::{QueryError, option};
use libration::expression::Expression;

/// Reads `NAME=VALUE` items, several of which may be in one text, separated by commas.
pub(super) fn values(items: &[String]) -> Result<Vec<(String, Expression)>, QueryError> {
    items.iter().flat_map(|items| at_commas(items)).map(value).collect()
}

/// The values in the form that the library takes.
pub(super) fn borrowed(values: &[(String, Expression)]) -> Vec<(&str, Expression)> {
    values.iter().map(|(name, value)| (name.as_str(), value.clone())).collect()
}

/// The name as equations have it: ω0 is omega0, θ̇ is theta'.
pub(crate) fn plain_name(name: &str) -> String {
    let name = name.trim();
    name.parse::<Expression>().map_or_else(|_| name.to_owned(), |symbol| symbol.to_string())
}

fn value(item: &str) -> Result<(String, Expression), QueryError> {
    let (name, value) = item.split_once('=').ok_or_else(|| {
        QueryError::usage(option("set"), format!("`{item}` has no value: give NAME=VALUE, such as mu=0.1"))
    })?;
    let value = value.parse().map_err(|error| {
        QueryError::usage(option("set"), format!("{}: {error}", name.trim()))
            .with_item(Some(&plain_name(name)))
    })?;
    Ok((plain_name(name), value))
}
