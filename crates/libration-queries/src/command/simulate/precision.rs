//! Precision of the states of a motion.

use super::motion::SimulatedMotion;
use libration::taylor::{Moment, MomentErrors, StateErrors, System};

/// The precision of a whole motion.
#[derive(Clone, Debug)]
pub(super) enum Precision {
    /// The errors are estimated.
    Estimated {
        /// The time of the last state that is determined in double precision, where not all are.
        determined_until: Option<f64>,
        /// Change of the last determined state caused by half a unit in the last place of the start.
        start_effect: Moment,
    },
    /// The reason why errors are not estimated.
    NotEstimated(&'static str),
}

impl SimulatedMotion<'_> {
    /// The reason why errors are not estimated; `None` if they are.
    pub(super) fn no_errors(&self) -> Option<&'static str> {
        self.no_errors.or_else(|| {
            let numbers = self.beginning().state.len();
            (numbers > StateErrors::MOST_COMPONENTS).then_some("the state has more than 64 numbers")
        })
    }

    /// The errors along the motion, initial or continued.
    pub(super) fn state_errors(&self, system: &System) -> Option<StateErrors> {
        if self.no_errors().is_some() {
            return None;
        }
        let (start, effort) = (self.beginning(), self.effort());
        let kept = self.mark().and_then(|mark| mark.errors.as_deref());
        let kept = kept.and_then(|numbers| StateErrors::resumed(system, &start, &effort, numbers));
        let errors = kept.unwrap_or_else(|| StateErrors::new(system, &start, &effort));
        Some(match self.gradients() {
            Some(gradients) => errors.with_formulas(gradients),
            None => errors,
        })
    }

    /// The precision of the whole motion.
    pub(super) fn precision(&self, errors: Option<&StateErrors>) -> Precision {
        match errors {
            Some(errors) => Precision::Estimated {
                determined_until: errors.determined_until(),
                start_effect: self.motion_state(&errors.effect_of_start()),
            },
            None => Precision::NotEstimated(self.no_errors().unwrap_or_default()),
        }
    }

    /// The errors of the motion alone and of its columns, from those of the integration; NaN if there are none.
    pub(super) fn own_errors(&self, errors: Option<MomentErrors>) -> MomentErrors {
        let unknown = |count: usize| vec![f64::NAN; count];
        let formulas = self.observables.map_or(0, |observables| observables.names().len());
        let MomentErrors { time, state, formulas } = errors.unwrap_or_else(|| MomentErrors {
            time: f64::NAN,
            state: unknown(self.beginning().state.len()),
            formulas: unknown(formulas),
        });
        let derivatives =
            self.sensitivities.map(|sensitivity| sensitivity.derivatives_in(&state)).unwrap_or_default();
        let Moment { state, .. } = self.motion_state(&Moment { time, state });
        MomentErrors { time, state, formulas: [formulas, derivatives].concat() }
    }
}
