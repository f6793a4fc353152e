//! The input of an integration: an initial state, parameters, times.

use crate::taylor::solution::Moment;
use crate::taylor::{IntegrationError, System};

/// One trajectory of a batch: its initial state, the values of the open parameters, and the times at which it is requested.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory<'a> {
    /// The initial state.
    pub start: Moment,
    /// The values of [`System::parameters`].
    pub parameters: Vec<f64>,
    /// All after the start in ascending order, or all before it in descending order.
    pub times: &'a [f64],
}

impl Trajectory<'_> {
    pub(in crate::taylor) fn check(&self, system: &System) -> Result<(), IntegrationError> {
        let Self { start, parameters, times } = self;
        let (got, wanted) = (start.state.len(), system.layout().numbers());
        if got != wanted {
            return Err(IntegrationError::StateLength { got, wanted });
        }
        let (got, wanted) = (parameters.len(), system.parameters().len());
        if got != wanted {
            return Err(IntegrationError::ParameterCount { got, wanted });
        }
        let given = start.state.iter().chain(parameters).chain([&start.time]);
        if let Some(&value) = given.into_iter().find(|value| !value.is_finite()) {
            return Err(IntegrationError::StartNotFinite(value));
        }
        if let Some(&time) = times.iter().find(|time| !time.is_finite()) {
            return Err(IntegrationError::TimeNotFinite(time));
        }
        let backward = times.last().is_some_and(|&last| last < start.time);
        let mut pairs = [start.time].into_iter().chain(times.iter().copied()).zip(times.iter().copied());
        match pairs.find(|(a, b)| if backward { b > a } else { b < a }) {
            Some((before, after)) => Err(IntegrationError::TimesNotInOrder { before, after }),
            None => Ok(()),
        }
    }
}
