//! A batch of trajectories, integrated in lanes.

use std::ops::ControlFlow;

use super::partial_solution::PartialSolution;
use super::rest::{Rest, rest};
use super::stepper::Stepper;
use crate::taylor::{
    Cause, Checkpoint, Effort, IntegrationError, Moment, Solution, Step, System, Trajectory,
};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Stage;

type SolutionResult = Result<Solution, IntegrationError>;

/// The lanes, and the present results of their motions.
#[derive(Debug)]
pub(in crate::taylor) struct Batch<'a, const N: usize> {
    system: &'a System,
    effort: Effort,
    stepper: Stepper<'a, N>,
    solutions: [Option<PartialSolution<'a>>; N],
    /// The checkpoint from which the motions are resumed, if they are.
    checkpoint: Option<&'a Checkpoint>,
}

/// The recipient of progress, which may cancel all motions.
pub(in crate::taylor) enum Observer<'w, const N: usize> {
    /// The number of finished motions, before each step.
    Progress(Watch<'w>),
    /// Each step of each motion, with the number of the motion.
    Steps(&'w mut dyn FnMut(usize, &LaneStep<'_, N>) -> ControlFlow<()>),
}

impl<const N: usize> Observer<'_, N> {
    /// Reports the number of finished motions; `true` cancels them all.
    fn cancels(&self, finished: usize) -> bool {
        matches!(self, Self::Progress(watch) if watch.reached(finished).is_err())
    }
}

/// A step of one motion, in its lane.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) struct LaneStep<'s, const N: usize> {
    pub(in crate::taylor) step: Step<'s>,
    pub(in crate::taylor) stepper: &'s Stepper<'s, N>,
    pub(in crate::taylor) solution: &'s PartialSolution<'s>,
    pub(in crate::taylor) lane: usize,
}

impl<'a, const N: usize> Batch<'a, N> {
    pub(in crate::taylor) fn new(system: &'a System, effort: &Effort) -> Self {
        let solutions = std::array::from_fn(|_| None);
        let stepper = Stepper::new(system, *effort);
        Self { system, effort: *effort, stepper, solutions, checkpoint: None }
    }

    /// The same batch, for motions that continue from a checkpoint.
    pub(in crate::taylor) fn resumed_from(self, checkpoint: Option<&'a Checkpoint>) -> Self {
        Self { checkpoint, ..self }
    }

    /// Integrates all motions to their ends.
    pub(in crate::taylor) fn integrate(
        &mut self,
        trajectories: &'a [Trajectory<'_>],
        mut observer: Observer<'_, N>,
    ) -> Vec<SolutionResult> {
        if let Observer::Progress(watch) = &observer {
            watch.begin(Stage::Whole, Some(trajectories.len()));
        }
        let mut outcomes: Vec<Option<SolutionResult>> = trajectories.iter().map(|_| None).collect();
        let mut waiting = trajectories.iter().enumerate();
        let mut finished = 0;
        let mut interrupted = false;
        loop {
            for lane in 0..N {
                while self.solutions[lane].is_none() && !interrupted {
                    let Some((number, trajectory)) = waiting.next() else { break };
                    outcomes[number] = self.start(lane, number, trajectory).err();
                    finished += usize::from(outcomes[number].is_some());
                }
            }
            if self.solutions.iter().all(Option::is_none) {
                break;
            }
            interrupted = interrupted || observer.cancels(finished);
            let ahead = self.stepper.look_ahead();
            for (lane, ahead) in ahead.into_iter().enumerate() {
                let Some(solution) = &mut self.solutions[lane] else { continue };
                let lane_of = Lane { stepper: &self.stepper, lane };
                let Err(end) =
                    lane_of.advance(solution, ahead, &self.effort, &mut interrupted, &mut observer)
                else {
                    continue;
                };
                if let Some(solution) = self.solutions[lane].take() {
                    let number = solution.number;
                    outcomes[number] = Some(conclude(
                        end,
                        solution,
                        self.system,
                        &self.effort,
                        &mut interrupted,
                        &mut observer,
                    ));
                    finished += 1;
                }
                self.stepper.idle(lane);
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

    /// Puts a motion into a lane; returns its outcome if there is nothing to integrate.
    fn start(
        &mut self,
        lane: usize,
        number: usize,
        trajectory: &'a Trajectory<'_>,
    ) -> Result<(), SolutionResult> {
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
}

/// The outcome of a motion that cannot be continued in the lanes; if a state
/// component has come to rest, the motion is continued outside of them.
fn conclude<const N: usize>(
    end: End,
    mut solution: PartialSolution<'_>,
    system: &System,
    effort: &Effort,
    interrupted: &mut bool,
    observer: &mut Observer<'_, N>,
) -> SolutionResult {
    let (cause, moment) = match end {
        End::Stopped(cause, moment) if Rest::may_explain(cause) => (cause, moment),
        end => return end.outcome(solution),
    };
    let Some(goal) = solution.goal() else { return End::Reached(moment).outcome(solution) };
    let parameters = solution.parameters().to_vec();
    let (system, start) = match rest(system, &moment, &parameters, goal < moment.time) {
        Some(Rest::In(system, start)) => (system, start),
        Some(Rest::Undecided) => return End::Stopped(Cause::Undecided, moment).outcome(solution),
        None => return End::Stopped(cause, moment).outcome(solution),
    };
    let mut stepper = Stepper::<N>::new(&system, *effort);
    stepper.start(0, &start, &parameters, goal);
    loop {
        *interrupted = *interrupted || observer.cancels(solution.number);
        let ahead = stepper.look_ahead()[0];
        let lane = Lane { stepper: &stepper, lane: 0 };
        if let Err(end) = lane.advance(&mut solution, ahead, effort, interrupted, observer) {
            return conclude(end, solution, &system, effort, interrupted, observer);
        }
        stepper.advance();
    }
}

/// One lane of a stepper.
struct Lane<'s, const N: usize> {
    stepper: &'s Stepper<'s, N>,
    lane: usize,
}

/// The reason why a motion ends.
enum End {
    Reached(Moment),
    Stopped(Cause, Moment),
}

impl End {
    fn outcome(self, solution: PartialSolution<'_>) -> SolutionResult {
        match self {
            Self::Reached(end) => Ok(solution.finished(end)),
            Self::Stopped(cause, end) => solution.stopped(cause, end),
        }
    }
}

impl<const N: usize> Lane<'_, N> {
    /// Takes the next step of a motion; returns the end if that is the last step.
    fn advance(
        &self,
        solution: &mut PartialSolution<'_>,
        ahead: Result<(), Cause>,
        effort: &Effort,
        interrupted: &mut bool,
        observer: &mut Observer<'_, N>,
    ) -> Result<(), End> {
        let Self { stepper, lane } = *self;
        let allowed = if *interrupted { Err(Cause::Interrupted) } else { solution.has_steps_left(effort) };
        if let Err(cause) = allowed.and(ahead) {
            let moment = stepper.moment(lane);
            let too_large = cause == Cause::Singularity && solution.overflows(&moment);
            return Err(End::Stopped(if too_large { Cause::Overflow } else { cause }, moment));
        }
        if matches!(observer, Observer::Progress(_))
            && solution.pass(stepper.block.start[lane], stepper.block.end[lane])
        {
            return Ok(());
        }
        let step = stepper.step(lane);
        let signs = stepper.signs(lane);
        let end = solution.take(&step, |event| stepper.event(event, lane), &signs, stepper.effort.relative);
        let taken = LaneStep { step, stepper, solution, lane };
        let stop = match observer {
            Observer::Progress(_) => false,
            Observer::Steps(each) => each(solution.number, &taken).is_break(),
        };
        if let Some(end) = end {
            return Err(End::Reached(end));
        }
        if solution.goal().is_none() {
            return Err(End::Reached(stepper.end(lane)));
        }
        *interrupted |= stop;
        if stop { Err(End::Stopped(Cause::Interrupted, stepper.end(lane))) } else { Ok(()) }
    }
}
