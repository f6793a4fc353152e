//! The number of bodies of a system in which this is a parameter.

use super::{ModelError, NamedSystem};
use libration_numbers::expression::Expression;

/// The equations for a given number of bodies, and the values of their parameters.
pub(super) struct Counted {
    pub(super) equations: String,
    pub(super) values: Vec<(String, Expression)>,
    /// The name of the count with its value.
    pub(super) count: Option<(String, Expression)>,
}

/// Maximum number of bodies.
const MOST: u32 = 1000;

impl Counted {
    /// Separates the count from the other values of a system.
    pub(super) fn new(named: &NamedSystem, values: &[(&str, Expression)]) -> Result<Self, ModelError> {
        let is_count = |name: &str| named.count == Some(name.trim());
        let others = values.iter().filter(|(name, _)| !is_count(name));
        let others = others.map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
        let Some(name) = named.count else {
            return Ok(Self { equations: named.equations.to_owned(), values: others, count: None });
        };
        let default = named
            .parameters
            .iter()
            .find(|parameter| parameter.name == name)
            .map_or("1", |parameter| parameter.default);
        let given = values.iter().find(|(name, _)| is_count(name)).map(|(_, value)| value.clone());
        let value = given.map_or_else(
            || default.parse().map_err(libration_numbers::expression::EquationError::from),
            Ok,
        )?;
        let refusal = || ModelError::NotACount { name, value: value.to_string(), most: MOST };
        let whole = value.to_f64().filter(|n| n.fract() == 0.0 && (1.0..=f64::from(MOST)).contains(n));
        let number = whole.ok_or_else(refusal)?;
        let equations = written_out(named.equations, name, number);
        Ok(Self { equations, values: others, count: Some((name.to_owned(), value)) })
    }
}

/// The equations with a number in place of the count, wherever this ends a range or is part of an index.
fn written_out(equations: &str, name: &str, number: f64) -> String {
    let next = number + 1.0;
    let ends = [
        (format!("..{name}"), format!("..{number}")),
        (format!("[{name}]"), format!("[{number}]")),
        (format!("[{name}+1]"), format!("[{next}]")),
    ];
    ends.iter()
        .fold(equations.to_owned(), |equations, (by_name, by_number)| equations.replace(by_name, by_number))
}
