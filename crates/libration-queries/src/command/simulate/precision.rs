//! Precision of the states of a motion.

use super::motion::SimulatedMotion;
use libration::taylor::{Moment, StateErrors, System};

/// The precision of a whole motion.
#[derive(Clone, Debug)]
pub(super) enum Precision {
    /// The errors are estimated.
    Estimated {
        /// The time of the last state that is determined in double precision, where not all are.
        determined_until: Option<f64>,
        /// Change of the last determined state that half a unit in the last place of the start causes.
        start_effect: Moment,
    },
    /// No error is: why.
    NotEstimated(&'static str),
}

/// The errors of a state with more numbers take longer than its motion: their number goes with the third power.
const MOST_NUMBERS: usize = 64;

impl SimulatedMotion<'_> {
    /// The reason why no errors are estimated, if none are.
    pub(super) fn no_errors(&self) -> Option<&'static str> {
        self.no_errors.or_else(|| {
            let numbers = self.beginning().state.len();
            (numbers > MOST_NUMBERS).then_some("the state has more than 64 numbers")
        })
    }

    /// The errors along the motion, begun or gone on with.
    pub(super) fn state_errors(&self, system: &System) -> Option<StateErrors> {
        if self.no_errors().is_some() {
            return None;
        }
        let (start, effort) = (self.beginning(), self.effort());
        let kept = self.mark().and_then(|mark| mark.errors.as_deref());
        let kept = kept.and_then(|numbers| StateErrors::resumed(system, &start, &effort, numbers));
        Some(kept.unwrap_or_else(|| StateErrors::new(system, &start, &effort)))
    }

    /// The precision of the whole motion.
    pub(super) fn precision(&self, errors: Option<&StateErrors>) -> Precision {
        match errors {
            Some(errors) => Precision::Estimated {
                determined_until: errors.determined_until(),
                start_effect: self.own(&errors.effect_of_start()),
            },
            None => Precision::NotEstimated(self.no_errors().unwrap_or_default()),
        }
    }

    /// The error of each number of the state of the motion alone, from that of the integration; not numbers where there are none.
    pub(super) fn own_error(&self, error: Option<Vec<f64>>) -> Vec<f64> {
        let state = error.unwrap_or_else(|| vec![f64::NAN; self.beginning().state.len()]);
        self.own(&Moment { time: 0.0, state }).state
    }

    /// The error of an event, with that of its time.
    pub(super) fn own_event_error(&self, error: Option<Moment>) -> Moment {
        let time = error.as_ref().map_or(f64::NAN, |error| error.time);
        Moment { time, state: self.own_error(error.map(|error| error.state)) }
    }
}
