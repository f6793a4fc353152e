//! Integration tolerances: one for all coordinates, or separate ones for some.

use super::values::plain_name;
use crate::query_error::{QueryError, option};
use libration::internals::InOrder;
use libration::taylor::{Effort, System};
use std::fmt;

/// A tolerance for each coordinate.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tolerances {
    /// Tolerance of the coordinates that are not named.
    pub(crate) usual: f64,
    pub(crate) separate: Vec<(String, f64)>,
}

/// Reads `1e-12`, `phi=1e-6`, or both.
pub(crate) fn tolerances(text: &str) -> Result<Tolerances, String> {
    let mut usual = None;
    let mut separate = vec![];
    for item in text.split(',') {
        match item.split_once('=') {
            Some((name, number)) => separate.push((plain_name(name), tolerance(number)?)),
            None if usual.is_none() => usual = Some(tolerance(item)?),
            None => return Err("two tolerances without a name: give one, and others as x=1e-6".to_owned()),
        }
    }
    separate.put_in_order(|(a, _), (b, _): &(String, f64)| a.cmp(b));
    Ok(Tolerances { usual: usual.unwrap_or(Tolerances::USUAL), separate })
}

fn tolerance(text: &str) -> Result<f64, String> {
    let [least, greatest] = Effort::TOLERANCES;
    let number = text.trim().parse().ok().filter(|number| (least..=greatest).contains(number));
    number.ok_or_else(|| format!("give a number from {least:e} to {greatest}, such as 1e-12"))
}

impl Tolerances {
    /// The default tolerance.
    const USUAL: f64 = 1e-12;

    pub(crate) fn effort(&self) -> Effort {
        Effort::to_tolerance(self.usual)
    }

    /// The system with the separate tolerances of coordinates.
    pub(crate) fn put_on(&self, system: System) -> Result<System, QueryError> {
        let tolerances: Vec<(&str, f64)> =
            self.separate.iter().map(|(name, tolerance)| (name.as_str(), *tolerance)).collect();
        system.with_tolerances(&tolerances).map_err(|error| QueryError::usage(option("tolerance"), error))
    }
}

/// `1e-12 per step, 1e-6 in phi`.
impl fmt::Display for Tolerances {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:e} per step", self.usual)?;
        self.separate.iter().try_for_each(|(name, tolerance)| write!(formatter, ", {tolerance:e} in {name}"))
    }
}
