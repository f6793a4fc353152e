//! A batch of trajectories, as many at a time as there are lanes.

use std::ops::ControlFlow;

use super::partial_solution::PartialSolution;
use super::stepper::Stepper;
use super::{Cause, Checkpoint, Effort, IntegrationError, Solution, Step, System, Trajectory};

type Outcome = Result<Solution, IntegrationError>;

/// The lanes, and what is known of the motions in them.
#[derive(Debug)]
pub(super) struct Batch<'a, const N: usize> {
    system: &'a System,
    effort: Effort,
    stepper: Stepper<'a, N>,
    solutions: [Option<PartialSolution<'a>>; N],
    /// Where the motions go on from, if they do not begin.
    checkpoint: Option<&'a Checkpoint>,
}

/// A step that one motion has taken, in its lane.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaneStep<'s, const N: usize> {
    pub(super) step: Step<'s>,
    pub(super) stepper: &'s Stepper<'s, N>,
    pub(super) solution: &'s PartialSolution<'s>,
    pub(super) lane: usize,
}

impl<'a, const N: usize> Batch<'a, N> {
    pub(super) fn new(system: &'a System, effort: &Effort) -> Self {
        let solutions = std::array::from_fn(|_| None);
        let stepper = Stepper::new(system, *effort);
        Self { system, effort: *effort, stepper, solutions, checkpoint: None }
    }

    /// The same, for motions that go on from a checkpoint.
    pub(super) fn resumed_from(self, checkpoint: Option<&'a Checkpoint>) -> Self {
        Self { checkpoint, ..self }
    }

    /// All motions to their ends.
    pub(super) fn integrate(
        &mut self,
        trajectories: &'a [Trajectory<'_>],
        watch: &mut dyn FnMut(usize, &LaneStep<'_, N>) -> ControlFlow<()>,
    ) -> Vec<Outcome> {
        let mut outcomes: Vec<Option<Outcome>> = trajectories.iter().map(|_| None).collect();
        let mut waiting = trajectories.iter().enumerate();
        let mut interrupted = false;
        loop {
            for lane in 0..N {
                while self.solutions[lane].is_none() && !interrupted {
                    let Some((number, trajectory)) = waiting.next() else { break };
                    outcomes[number] = self.start(lane, number, trajectory).err();
                }
            }
            if self.solutions.iter().all(Option::is_none) {
                break;
            }
            let ahead = self.stepper.look_ahead();
            for (lane, ahead) in ahead.into_iter().enumerate() {
                let Some(solution) = self.solutions[lane].take() else { continue };
                let number = solution.number;
                match self.advance(lane, solution, ahead, &mut interrupted, watch) {
                    Ok(solution) => self.solutions[lane] = Some(solution),
                    Err(outcome) => {
                        self.stepper.idle(lane);
                        outcomes[number] = Some(outcome);
                    }
                }
            }
            self.stepper.advance();
        }
        let never = |trajectory: &Trajectory<'_>| {
            PartialSolution::new(0, trajectory, self.system)
                .stopped(Cause::Interrupted, trajectory.start.clone())
        };
        outcomes
            .into_iter()
            .zip(trajectories)
            .map(|(outcome, trajectory)| outcome.unwrap_or_else(|| never(trajectory)))
            .collect()
    }

    /// Puts a motion into a lane; the outcome when it has no way to go.
    fn start(&mut self, lane: usize, number: usize, trajectory: &'a Trajectory<'_>) -> Result<(), Outcome> {
        let Effort { relative, absolute, .. } = self.effort;
        trajectory.check(self.system).map_err(Err)?;
        if !self.effort.is_possible() {
            return Err(Err(IntegrationError::Tolerance { relative, absolute }));
        }
        let mut solution = PartialSolution::new(number, trajectory, self.system);
        if let Some(checkpoint) = self.checkpoint {
            solution.resume(checkpoint);
        }
        solution.sample_start();
        match solution.goal() {
            None => Err(Ok(solution.finished(trajectory.start.clone()))),
            Some(goal) => {
                self.stepper.start(lane, &trajectory.start, &trajectory.parameters, goal);
                if let Some(checkpoint) = self.checkpoint {
                    self.stepper.resume(lane, checkpoint);
                }
                self.solutions[lane] = Some(solution);
                Ok(())
            }
        }
    }

    /// Takes the next step of one motion; the outcome when it is the last one.
    fn advance(
        &self,
        lane: usize,
        mut solution: PartialSolution<'a>,
        ahead: Result<(), Cause>,
        interrupted: &mut bool,
        watch: &mut dyn FnMut(usize, &LaneStep<'_, N>) -> ControlFlow<()>,
    ) -> Result<PartialSolution<'a>, Outcome> {
        let allowed =
            if *interrupted { Err(Cause::Interrupted) } else { solution.has_steps_left(&self.effort) };
        if let Err(cause) = allowed.and(ahead) {
            let moment = self.stepper.moment(lane);
            let too_large = cause == Cause::Singularity && solution.overflows(&moment);
            return Err(solution.stopped(if too_large { Cause::Overflow } else { cause }, moment));
        }
        let step = self.stepper.step(lane);
        let end = solution.take(&step, |event| self.stepper.event(event, lane), self.effort.relative);
        let taken = LaneStep { step, stepper: &self.stepper, solution: &solution, lane };
        let stop = watch(solution.number, &taken).is_break();
        let end_of_step = self.stepper.end(lane);
        if let Some(end) = end {
            return Err(Ok(solution.finished(end)));
        }
        if solution.goal().is_none() {
            return Err(Ok(solution.finished(end_of_step)));
        }
        *interrupted |= stop;
        if stop { Err(solution.stopped(Cause::Interrupted, end_of_step)) } else { Ok(solution) }
    }
}
