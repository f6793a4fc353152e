//! A motion with what is asked about it.

use super::events::Watched;
use super::resume::{Earlier, Mark, Question};
use crate::arguments::{Initial, Times, Tolerances};
use libration::systems::{Model, Observables};
use libration::taylor::{Effort, Moment};

/// A motion to be integrated, with what is asked about it.
pub(super) struct SimulatedMotion<'a> {
    pub(super) model: &'a Model,
    pub(super) question: Question,
    pub(super) initial: Initial,
    pub(super) times: &'a Times,
    pub(super) tolerances: &'a Tolerances,
    pub(super) watched: &'a Watched,
    /// Formulas whose values stand beside the state.
    pub(super) observables: Option<&'a Observables>,
    pub(super) earlier: Option<Earlier>,
}

impl SimulatedMotion<'_> {
    /// What the system is called: its key, or the equations as they were understood.
    pub(super) fn name(&self) -> String {
        self.model.key().map_or_else(|| self.model.equation().to_string(), str::to_owned)
    }

    /// The values of the columns that were asked for.
    pub(super) fn columns_at(&self, moment: &Moment) -> Option<Vec<f64>> {
        self.observables.map(|observables| observables.values_at(moment))
    }

    /// What these are called.
    pub(super) fn column_names(&self) -> &[String] {
        self.observables.map_or(&[], |observables| observables.names())
    }

    pub(super) fn effort(&self) -> Effort {
        self.tolerances.effort()
    }

    /// The state at t = 0.
    pub(super) fn beginning(&self) -> Moment {
        Moment { time: 0.0, state: self.initial.state.clone() }
    }

    /// Where it is gone on from.
    pub(super) fn mark(&self) -> Option<&Mark> {
        self.earlier.as_ref().and_then(Earlier::mark)
    }
}
