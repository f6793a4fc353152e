//! A motion with the quantities requested for it.

use super::events::Watched;
use super::resume::{Earlier, Mark, RunParameters};
use crate::arguments::{Initial, Times, Tolerances};
use libration::systems::{Model, Observables};
use libration::taylor::{Effort, Gradients, Moment, Sensitivities};

/// A motion to be integrated, with the quantities requested for it.
pub(super) struct SimulatedMotion<'a> {
    pub(super) model: &'a Model,
    pub(super) question: RunParameters,
    pub(super) initial: Initial,
    pub(super) times: &'a Times,
    pub(super) tolerances: &'a Tolerances,
    pub(super) watched: &'a Watched,
    /// Formulas whose values are listed in addition to the state.
    pub(super) observables: Option<&'a Observables>,
    /// Sensitivities to parameters and initial values.
    pub(super) sensitivities: Option<&'a Sensitivities>,
    pub(super) earlier: Option<Earlier>,
    /// Reason why errors of the states are not requested; `None` if they are.
    pub(super) no_errors: Option<&'static str>,
}

impl SimulatedMotion<'_> {
    /// The name of the system: its key, or the equations as they were understood.
    pub(super) fn name(&self) -> String {
        self.model.key().map_or_else(|| self.model.equation().to_string(), str::to_owned)
    }

    /// The values of the columns that were requested, in a state of the integration.
    pub(super) fn columns_at(&self, moment: &Moment) -> Option<Vec<f64>> {
        let formulas = self.observables.map(|observables| observables.values_at(&self.motion_state(moment)));
        let derivatives = self.sensitivities.map(|sensitivity| sensitivity.derivatives_in(&moment.state));
        match (formulas, derivatives) {
            (None, None) => None,
            (formulas, derivatives) => {
                Some([formulas.unwrap_or_default(), derivatives.unwrap_or_default()].concat())
            }
        }
    }

    /// The formulas of the columns with their derivatives.
    pub(super) fn gradients(&self) -> Option<Gradients> {
        let gradients = self.observables.map(Observables::gradients);
        gradients.map(|gradient| match self.sensitivities {
            Some(sensitivities) => gradient.among(sensitivities),
            None => gradient,
        })
    }

    /// The names of the columns.
    pub(super) fn column_names(&self) -> Vec<String> {
        let formulas = self.observables.map_or(&[][..], |observables| observables.names());
        [formulas, &self.sensitivities.map_or(vec![], Sensitivities::names)].concat()
    }

    /// The state of the motion alone, in a state of the integration.
    pub(super) fn motion_state(&self, moment: &Moment) -> Moment {
        let state = self
            .sensitivities
            .map_or_else(|| moment.state.clone(), |sensitivities| sensitivities.state_in(&moment.state));
        Moment { time: moment.time, state }
    }

    pub(super) fn effort(&self) -> Effort {
        self.tolerances.effort()
    }

    /// The state of the integration at t = 0.
    pub(super) fn beginning(&self) -> Moment {
        let state = &self.initial.state;
        self.sensitivities.map_or_else(
            || Moment { time: 0.0, state: state.clone() },
            |sensitivities| sensitivities.start(state),
        )
    }

    /// The mark from which the motion is continued.
    pub(super) fn mark(&self) -> Option<&Mark> {
        self.earlier.as_ref().and_then(Earlier::mark)
    }
}
