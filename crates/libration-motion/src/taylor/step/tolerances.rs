//! Individual tolerances of coordinates.

use super::allowance::{Allowance, ROUNDING};
use crate::taylor::{Effort, StateLayout};

/// The reason why coordinates cannot have the given tolerances.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ToleranceError {
    /// A name that is not a coordinate, such as that of a velocity.
    #[error("the system has no coordinate `{name}`: it has {}", known.join(", "))]
    NoCoordinate {
        /// The requested name.
        name: String,
        /// The names of the coordinates.
        known: Vec<String>,
    },
    /// A coordinate with two tolerances.
    #[error("{0} has two tolerances: give it one")]
    Twice(String),
    /// A tolerance that cannot be met.
    #[error("the tolerance of {coordinate} is {relative:?}: give one from 1e-18 to 0.1")]
    OutOfRange {
        /// The coordinate.
        coordinate: String,
        /// The given tolerance.
        relative: f64,
    },
}

/// The individual tolerances of the coordinates; zero for those with the common tolerance.
pub(in crate::taylor) fn own_tolerances(
    coordinates: &[String],
    given: &[(&str, f64)],
) -> Result<Vec<f64>, ToleranceError> {
    let [least, greatest] = Effort::TOLERANCES;
    let mut tolerances = vec![0.0; coordinates.len()];
    for (name, relative) in given {
        let (named, relative) = ((*name).to_owned(), *relative);
        let Some(index) = coordinates.iter().position(|other| other == name) else {
            return Err(ToleranceError::NoCoordinate { name: named, known: coordinates.to_vec() });
        };
        if tolerances[index] > 0.0 {
            return Err(ToleranceError::Twice(named));
        }
        if !(least..=greatest).contains(&relative) {
            return Err(ToleranceError::OutOfRange { coordinate: named, relative });
        }
        tolerances[index] = relative;
    }
    Ok(tolerances)
}

/// The effort with the smallest of all tolerances, and the allowed error of each state component.
pub(in crate::taylor) fn allowances(
    tolerances: &[f64],
    layout: &StateLayout,
    effort: &Effort,
) -> (Effort, Vec<Allowance>) {
    let relative = |coordinate: usize| {
        if tolerances[coordinate] > 0.0 { tolerances[coordinate] } else { effort.relative }
    };
    let least = (0..tolerances.len()).map(relative).fold(f64::INFINITY, f64::min);
    let least = if least.is_finite() { least } else { effort.relative };
    let tightest = Effort { relative: least, ..*effort };
    let allowance = |coordinate: usize| {
        let relative = relative(coordinate);
        let log2_longer = tightest.log2_longer(relative);
        Allowance { relative, log2_longer, weight: least.max(ROUNDING) / relative.max(ROUNDING) }
    };
    let coordinates = (0..layout.coordinates()).map(allowance);
    let velocities =
        (0..layout.coordinates()).filter(|coordinate| layout.velocity(*coordinate).is_some()).map(allowance);
    (tightest, coordinates.chain(velocities).collect())
}
