//! Ensembles: many motions of one system that are integrated together, and whose states are requested at one time after another.
//!
//! Each motion keeps its present step. Those whose steps end before the requested time are integrated side by side in lanes.

use super::stepper::Stepper;
use super::trajectory::Trajectory;
use crate::taylor::{Cause, Checkpoint, Effort, IntegrationError, LANES, Moment, OwnedStep, System};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress, Stage};

/// Many motions of a system, from t = 0 or other initial times, without a final time.
///
/// # Accuracy
/// As [`integrate`](crate::taylor::integrate()) with the same effort; the results are
/// the same bit for bit, except for steps of `integrate` that end at its last time.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Ensemble, Moment, System};
/// let system = System::new(&"theta'' + theta'/2 + sin(theta) = 3/2*cos(2t/3)".parse()?)?;
/// let starts: Vec<Moment> =
///     (0..100).map(|n| Moment { time: 0.0, state: vec![0.2 + 1e-6 * f64::from(n), 0.0] }).collect();
/// let mut ensemble = Ensemble::new(system, &starts, &Effort::to_tolerance(1e-8))?;
/// let states = ensemble.states_at(10.0, &Quiet)?;
/// assert_eq!(states.len(), 200);
/// assert!((states[0] - states[198]).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Ensemble {
    system: System,
    effort: Effort,
    members: Vec<Member>,
}

/// One motion: its present step and the data from which it continues.
#[derive(Clone, Debug)]
struct Member {
    state: KnownState,
    way: Way,
}

#[derive(Clone, Debug)]
enum KnownState {
    At(Moment),
    During(OwnedStep),
}

#[derive(Clone, Debug)]
enum Way {
    Start,
    From(Checkpoint),
    Ended(Cause),
}

/// Goal of all steps, which is never reached.
const HORIZON: f64 = 1e15;

impl Ensemble {
    /// The motions from these states.
    ///
    /// # Errors
    /// A system with open parameters; a start or a tolerance that is not allowed.
    pub fn new(system: System, starts: &[Moment], effort: &Effort) -> Result<Self, IntegrationError> {
        let Effort { relative, absolute, .. } = *effort;
        if !effort.is_possible() {
            return Err(IntegrationError::Tolerance { relative, absolute });
        }
        for start in starts {
            Trajectory { start: start.clone(), parameters: vec![], times: &[HORIZON] }.check(&system)?;
        }
        let members =
            starts.iter().map(|start| Member { state: KnownState::At(start.clone()), way: Way::Start });
        Ok(Self { members: members.collect(), system, effort: *effort })
    }

    /// The number of motions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Returns `true` if there are no motions.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// The common system of the motions.
    #[must_use]
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The states at a time, in one array, motion by motion: for each motion the components named by [`System::state_names`]; NaN before its
    /// start and after its end, and if a later time was requested of it before.
    ///
    /// `progress` is called with the number of motions that have reached the time. A
    /// cancelled call keeps the steps so far, and another call continues from them.
    ///
    /// # Errors
    /// The call is cancelled.
    pub fn states_at(&mut self, time: f64, progress: &dyn Progress) -> Result<Vec<f64>, Interrupted> {
        let watch = &Watch::new(progress);
        watch.begin(Stage::Whole, Some(self.members.len()));
        let mut behind: Vec<usize> = (0..self.members.len()).collect();
        let Self { system, effort, members } = self;
        let mut stepper = Stepper::<LANES>::new(system, *effort);
        loop {
            behind.retain(|&number| members[number].is_behind(time));
            if behind.is_empty() {
                break;
            }
            for group in behind.chunks(LANES) {
                watch.reached(members.len() - behind.len())?;
                step(&mut stepper, members, group);
            }
        }
        let numbers = self.system.layout().numbers();
        let nowhere = || vec![f64::NAN; numbers];
        Ok(self.members.iter().flat_map(|member| member.state_at(time).unwrap_or_else(nowhere)).collect())
    }

    /// The motions that have ended, each with its number from 0 and the cause.
    pub fn ended(&self) -> impl Iterator<Item = (usize, Cause)> {
        self.members.iter().enumerate().filter_map(|(number, member)| match member.way {
            Way::Ended(cause) => Some((number, cause)),
            _ => None,
        })
    }
}

/// The next steps of these motions, at most as many as there are lanes.
fn step(stepper: &mut Stepper<'_, LANES>, members: &mut [Member], group: &[usize]) {
    for (lane, &number) in group.iter().enumerate() {
        members[number].begin(stepper, lane);
    }
    (group.len()..LANES).for_each(|lane| stepper.idle(lane));
    let ahead = stepper.look_ahead();
    for ((lane, &number), ahead) in group.iter().enumerate().zip(ahead) {
        let member = &mut members[number];
        match ahead {
            Err(cause) => member.way = Way::Ended(cause),
            Ok(()) => {
                member.state = KnownState::During(stepper.step(lane).to_owned_step());
                member.way = Way::From(stepper.checkpoint_to_this_goal(lane));
            }
        }
    }
}

impl Member {
    /// Puts the motion into a lane.
    fn begin(&self, stepper: &mut Stepper<'_, LANES>, lane: usize) {
        match (&self.way, &self.state) {
            (Way::From(checkpoint), _) => {
                let here = Moment { time: checkpoint.time, state: checkpoint.rounded_state() };
                stepper.start(lane, &here, &[], HORIZON);
                stepper.resume(lane, checkpoint);
            }
            (_, KnownState::At(start)) => stepper.start(lane, start, &[], HORIZON),
            (_, KnownState::During(_)) => stepper.idle(lane),
        }
    }

    fn is_behind(&self, time: f64) -> bool {
        let until = match &self.state {
            KnownState::At(start) => start.time,
            KnownState::During(step) => step.step().end(),
        };
        time > until && until < HORIZON && !matches!(self.way, Way::Ended(_))
    }

    #[expect(clippy::float_cmp, reason = "a start is known at its time alone")]
    fn state_at(&self, time: f64) -> Option<Vec<f64>> {
        match &self.state {
            KnownState::At(start) => (time == start.time).then(|| start.state.clone()),
            KnownState::During(step) => {
                let step = step.step();
                (step.start() <= time && time <= step.end()).then(|| step.state_at(time))
            }
        }
    }
}
