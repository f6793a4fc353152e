//! A motion integrated once, so that its steps can be visited again from the last to the first.

use std::ops::ControlFlow;

use super::roundings_of_steps::terms;
use crate::taylor::{
    Checkpoint, Effort, IntegrationError, Moment, Occurrence, Solution, Start, System, integrate_from,
};

/// Starts from which a motion can be resumed, and its end.
#[derive(Debug)]
pub(in crate::taylor) struct Survey {
    /// Stretches of some thousand steps, from whose starts the motion can be resumed.
    pub(in crate::taylor) stretches: Vec<StepRange>,
    pub(in crate::taylor) solution: Solution,
    /// The event that ended the motion.
    pub(in crate::taylor) ending: Option<Occurrence>,
    /// The sum of the magnitudes of all terms of each state component in the last step.
    pub(in crate::taylor) sizes: Vec<f64>,
}

/// Some consecutive steps.
#[derive(Debug)]
pub(in crate::taylor) struct StepRange {
    pub(in crate::taylor) start: Start,
    pub(in crate::taylor) steps: usize,
}

impl Survey {
    pub(in crate::taylor) fn new(
        system: &System,
        start: &Moment,
        last: f64,
        effort: &Effort,
    ) -> Result<Self, IntegrationError> {
        /// Number of steps stored at a time: those of most motions, in a few megabytes.
        const STEPS: usize = 4096;
        let start = Start::State(start.clone());
        let (mut stretches, mut ending, mut sizes) = (vec![], None, vec![]);
        let mut stretch = StepRange { start: start.clone(), steps: 0 };
        let mut next = None::<Checkpoint>;
        let solution = integrate_from(system, &start, &[last], effort, |accepted| {
            if let Some(checkpoint) = next.take() {
                let next = StepRange { start: Start::Checkpoint(checkpoint), steps: 0 };
                stretches.push(std::mem::replace(&mut stretch, next));
            }
            stretch.steps += 1;
            next = if stretch.steps < STEPS { None } else { accepted.checkpoint() };
            let (step, ended) = (accepted.step(), accepted.ended_at());
            ending = ended.and_then(|_| accepted.events().last().cloned());
            let length = ended.unwrap_or(step.end()) - step.start();
            sizes = (0..step.numbers()).map(|number| terms(step, number, 0, length)).collect();
            ControlFlow::Continue(())
        })?;
        stretches.push(stretch);
        Ok(Self { stretches, solution, ending, sizes })
    }
}
