//! Integration of the motions of a table on all cores, as many together as there are lanes.

use super::super::ending::Ending;
use super::super::motion::SimulatedMotion;
use super::super::run::ended;
use super::list::Listed;
use super::setting::Setting;
use crate::figure::simulation::Trace;
use crate::{interrupt, parallel};
use libration::systems::EnergyBalance;
use libration::taylor::{
    AcceptedStep, IntegrationError, Moment, Solution, Step, Trajectory, integrate_many_stepwise,
};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::available_parallelism;

/// A motion as far as it came.
pub(super) struct Followed<'a> {
    pub(super) solution: Solution,
    pub(super) ending: Ending,
    /// The drift of the energy and its uncertainty, or the reason why it is unknown.
    pub(super) drift: Result<[f64; 2], String>,
    pub(super) trace: Option<Trace<'a>>,
}

/// Motions with the same parameters, for one core.
struct Piece<'m, 'a> {
    setting: &'a Setting,
    /// The motions with their positions among all.
    motions: Vec<(usize, &'m Listed<'a>)>,
}

/// Largest number of motions that are one piece of work.
const PIECE: usize = 32;

/// All motions except those that have not begun at a cancellation.
pub(super) fn all<'a>(motions: &[Listed<'a>], drawn: bool) -> Vec<Option<Followed<'a>>> {
    let progress = MotionsProgress { thousandths: AtomicU64::new(0), last: motions[0].motion.times.last() };
    let how_far = || progress.shown(motions.len());
    let work = |piece: &Piece<'_, 'a>| piece.follow(drawn, &progress);
    let pieces = pieces(motions);
    let followed = parallel::with_progress(how_far, || parallel::map(&pieces, work));
    let mut all: Vec<Option<Followed<'a>>> = motions.iter().map(|_| None).collect();
    for (piece, followed) in pieces.iter().zip(followed) {
        for ((index, _), followed) in piece.motions.iter().zip(followed) {
            all[*index] = followed;
        }
    }
    all
}

/// Motions with the same parameters together, shared among the cores.
fn pieces<'m, 'a>(motions: &'m [Listed<'a>]) -> Vec<Piece<'m, 'a>> {
    let mut groups: Vec<Piece<'m, 'a>> = vec![];
    for (index, listed) in motions.iter().enumerate() {
        let same = |piece: &&mut Piece<'_, '_>| std::ptr::eq(piece.setting, listed.setting);
        match groups.iter_mut().rev().find(same) {
            Some(piece) => piece.motions.push((index, listed)),
            None => groups.push(Piece { setting: listed.setting, motions: vec![(index, listed)] }),
        }
    }
    let cores = available_parallelism().map_or(1, usize::from);
    let share = motions.len().div_ceil(cores).min(PIECE);
    let shared = groups.iter().flat_map(|group| {
        let piece = |some: &[_]| Piece { setting: group.setting, motions: some.to_vec() };
        group.motions.chunks(share).map(piece).collect::<Vec<_>>()
    });
    shared.collect()
}

impl<'a> Piece<'_, 'a> {
    /// Integrates the motions; `None` for those that had not begun when the run was cancelled.
    fn follow(&self, drawn: bool, progress: &MotionsProgress) -> Vec<Option<Followed<'a>>> {
        let followed = match self.motions[0].1.motion.goes_both_ways() {
            true => self.motions.iter().map(|(_, listed)| both_ways(listed, drawn, progress)).collect(),
            false => self.side_by_side(drawn, progress),
        };
        let begun = |followed: &Followed<'_>| {
            followed.solution.steps > 0 || !matches!(followed.ending, Ending::Interrupted(_))
        };
        followed.into_iter().map(|followed| Some(followed).filter(begun)).collect()
    }

    /// All after the start, or all before it.
    fn side_by_side(&self, drawn: bool, progress: &MotionsProgress) -> Vec<Followed<'a>> {
        let first = &self.motions[0].1.motion;
        let times: Vec<f64> = first.times.iter().collect();
        let starts = self.motions.iter().map(|(_, listed)| listed.motion.beginning());
        let trajectories: Vec<Trajectory<'_>> =
            starts.map(|start| Trajectory { start, parameters: vec![], times: &times }).collect();
        let mut accounts: Vec<Account<'_, 'a>> =
            self.motions.iter().map(|(_, listed)| Account::new(listed, drawn)).collect();
        let watch = |number: usize, step: &Step<'_>| accounts[number].follow(step, progress);
        let outcomes = integrate_many_stepwise(&self.setting.system, &trajectories, &first.effort(), watch);
        let motions = self.motions.iter().zip(accounts).zip(outcomes);
        motions.map(|(((_, listed), account), outcome)| account.close(listed, outcome, progress)).collect()
    }
}

/// The account of a motion during the integration.
struct Account<'m, 'a> {
    motion: &'m SimulatedMotion<'a>,
    balance: Option<EnergyBalance<'a>>,
    trace: Option<Trace<'a>>,
    /// Progress already reported, in thousandths.
    told: u64,
}

impl<'m, 'a> Account<'m, 'a> {
    fn new(listed: &'m Listed<'a>, drawn: bool) -> Self {
        let setting = listed.setting;
        let motion = &listed.motion;
        let state = motion.motion_state(&motion.beginning());
        let balance = setting.energy.as_ref().ok().map(|energy| energy.balance(&state));
        let last = motion.times.last();
        let trace = drawn.then(|| Trace::new(&setting.model, setting.observables.as_ref(), last));
        Self { motion, balance, trace, told: 0 }
    }

    fn follow(&mut self, step: &Step<'_>, progress: &MotionsProgress) -> ControlFlow<()> {
        if let Some(balance) = &mut self.balance {
            let end = Moment { time: step.end(), state: step.state_at(step.end()) };
            balance.record(&self.motion.motion_state(&end));
        }
        if let Some(trace) = &mut self.trace {
            trace.follow(step, step.end());
        }
        progress.tell(&mut self.told, step.end());
        interrupt::check()
    }

    fn close(
        mut self,
        listed: &Listed<'a>,
        outcome: Result<Solution, IntegrationError>,
        progress: &MotionsProgress,
    ) -> Followed<'a> {
        progress.tell(&mut self.told, progress.last);
        let drift = self
            .balance
            .as_ref()
            .map_or([f64::NAN; 2], |balance| [balance.drift(), balance.drift_uncertainty()]);
        let (ending, solution) = concluded(listed, outcome);
        let mut trace = self.trace;
        if let Some(trace) = &mut trace {
            trace.cut(solution.end.time);
            for event in &solution.events {
                let happening = listed.motion.watched.happening(event);
                trace.mark(listed.motion.watched.coordinate(&happening), event.time, &event.state);
            }
        }
        let drift = listed.setting.energy.as_ref().map(|_| drift).map_err(Clone::clone);
        Followed { solution, ending, drift, trace }
    }
}

/// Follows a motion on both sides of the start.
fn both_ways<'a>(listed: &Listed<'a>, drawn: bool, progress: &MotionsProgress) -> Followed<'a> {
    let Setting { system, energy, .. } = listed.setting;
    let mut sides = drawn.then(|| listed.motion.sides());
    let follow = |step: &AcceptedStep<'_>| {
        if let Some(sides) = &mut sides {
            sides.follow(step.step());
        }
        interrupt::check()
    };
    let (outcome, drift) = listed.motion.integrate_both_ways(system, energy.as_ref().ok(), follow);
    progress.tell(&mut 0, progress.last);
    let (ending, solution) = concluded(listed, outcome);
    let drift = energy.as_ref().map(|_| drift).map_err(Clone::clone);
    let trace = sides.map(|sides| listed.motion.joined(sides, &solution));
    Followed { solution, ending, drift, trace }
}

/// The ending of a motion.
fn concluded(listed: &Listed<'_>, outcome: Result<Solution, IntegrationError>) -> (Ending, Solution) {
    let nothing = || Solution { samples: vec![], events: vec![], end: listed.motion.beginning(), steps: 0 };
    match ended(outcome, &listed.motion) {
        Ok((Ending::Complete, solution)) => match listed.motion.until(&listed.setting.system, &solution) {
            Ok(ending) => (ending, solution),
            Err(failure) => (Ending::Stopped(failure.to_string()), solution),
        },
        Ok((ending, solution)) => (ending, solution),
        Err(failure) => (Ending::Stopped(failure.to_string()), nothing()),
    }
}

/// The progress of all motions.
struct MotionsProgress {
    /// Progress of the motions, in thousandths of the time to the last sample, added up.
    thousandths: AtomicU64,
    last: f64,
}

impl MotionsProgress {
    /// Adds the progress of a motion up to a time.
    fn tell(&self, told: &mut u64, time: f64) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 1000")]
        let now = (1000.0 * (time / self.last).clamp(0.0, 1.0)) as u64;
        let more = now.saturating_sub(*told);
        if more > 0 {
            self.thousandths.fetch_add(more, Ordering::Relaxed);
            *told = now;
        }
    }

    fn shown(&self, all: usize) -> String {
        let thousandths = self.thousandths.load(Ordering::Relaxed);
        format!("{}.{} of {all} motions", thousandths / 1000, thousandths % 1000 / 100)
    }
}
