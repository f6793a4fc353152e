//! Measurement of one motion and its neighbours.

use super::super::extent::Extent;
use super::super::structure::{angles, cyclic, theorem};
use super::deviation::{Deviation, unequal_part};
use super::verdict::Evidence;
use super::{Doubt, LyapunovError, LyapunovVerdict, Regularity, Schedule};
use crate::taylor::{Cause, Effort, IntegrationError, Moment, System, integrate_stepwise, with_tangents};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Stage;

/// The equations, the schedule and the units of all motions in one measurement.
pub(super) struct Laboratory<'a> {
    plain: System,
    /// The equations of motion with those of one deviation.
    extended: System,
    schedule: &'a Schedule,
    effort: &'a Effort,
    units: Vec<f64>,
    /// Components of the state that may grow without bound: angles, and coordinates on which nothing depends.
    unconfined: Vec<bool>,
    /// The regularity that follows without a measurement.
    regularity: Option<Regularity>,
    /// The time and state of the given motion after the transient.
    settled: Moment,
}

impl<'a> Laboratory<'a> {
    pub(super) fn new(
        equation: &Equation,
        start: &Moment,
        schedule: &'a Schedule,
        effort: &'a Effort,
        watch: &Watch<'_>,
    ) -> Result<Self, LyapunovError> {
        let angles = angles(equation);
        let plain = System::new(equation)?;
        let extended = System::new(&with_tangents(equation, 1))?;
        let (extent, settled) = survey(&plain, start, schedule, effort, watch)?;
        let rests = extent.widths().iter().all(|width| *width == 0.0);
        let rest = rests.then_some(Regularity::AtRest);
        let regularity = theorem(equation).map(Regularity::Theorem).or(rest);
        let units = extent.units(&angles);
        let unconfined =
            angles.iter().zip(cyclic(equation)).map(|(angle, cyclic)| *angle || cyclic).collect();
        Ok(Self { plain, extended, schedule, effort, units, unconfined, regularity, settled })
    }

    /// Measures the requested motion.
    pub(super) fn measure(&self, watch: &Watch<'_>) -> Result<Evidence, LyapunovError> {
        watch.begin(Stage::Motion { number: 0 }, Some(self.schedule.intervals));
        self.follow(self.settled.clone(), watch)
    }

    /// Follows a motion through the schedule, or until it is cancelled.
    fn follow(&self, settled: Moment, watch: &Watch<'_>) -> Result<Evidence, LyapunovError> {
        let mut evidence = Evidence::new(self.schedule.interval, settled.state.len());
        let mut deviation =
            Deviation::new(&self.extended, self.plain.layout(), settled, &self.units, *self.effort);
        let going = |evidence: &Evidence| evidence.record.intervals() < self.schedule.intervals;
        while going(&evidence) && evidence.stopped.is_none() {
            match deviation.go_on(self.schedule.interval) {
                Ok(growth) => evidence.add(growth, &deviation.moment().state, self.schedule.intervals),
                Err(cause) => evidence.stopped = Some(cause),
            }
            if watch.reached(evidence.record.intervals()).is_err() && going(&evidence) {
                evidence.stopped = evidence.stopped.or(Some(Cause::Interrupted));
            }
        }
        match evidence.stopped.filter(|_| evidence.record.intervals() == 0) {
            Some(cause) => Err(LyapunovError::Nothing(cause)),
            None => Ok(evidence),
        }
    }

    /// The known verdict, or that of a motion; if the motion looks chaotic, its neighbours must confirm it.
    pub(super) fn verdict(&self, evidence: &Evidence, start: &Moment, watch: &Watch<'_>) -> LyapunovVerdict {
        if let Some(regularity) = self.regularity {
            return LyapunovVerdict::Regular(regularity);
        }
        let verdict = evidence.verdict(self.effort, &self.unconfined);
        if verdict != LyapunovVerdict::Chaotic {
            return verdict;
        }
        let doubts = (1..=NEIGHBOURS).map(|neighbour| self.doubt_from(neighbour, evidence, start, watch));
        doubts.flatten().next().map_or(LyapunovVerdict::Chaotic, LyapunovVerdict::Undecided)
    }

    /// Returns the evidence of a neighbouring motion against chaos.
    fn doubt_from(
        &self,
        neighbour: usize,
        evidence: &Evidence,
        start: &Moment,
        watch: &Watch<'_>,
    ) -> Option<Doubt> {
        watch.begin(Stage::Motion { number: neighbour }, Some(self.schedule.intervals));
        let times = [start.time + self.schedule.transient];
        let settled =
            integrate_stepwise(&self.plain, &self.displaced(start, neighbour), &times, self.effort, |_| {
                watch.flow()
            });
        match settled.map_err(LyapunovError::from).and_then(|solution| self.follow(solution.end, watch)) {
            Err(error) => Some(Doubt::Stopped(cause_of(error))),
            Ok(Evidence { stopped: Some(cause), .. }) => Some(Doubt::Stopped(cause)),
            Ok(other) => {
                let verdict = other.verdict(self.effort, &self.unconfined);
                let grows =
                    matches!(verdict, LyapunovVerdict::Chaotic | LyapunovVerdict::Undecided(Doubt::Unsteady));
                let same = grows && evidence.agrees_with(&other);
                (!same).then(|| Doubt::Neighbours { exponent: other.record.exponent() })
            }
        }
    }

    /// The start, displaced by about a millionth of the motion's extent, in different directions for each neighbour.
    fn displaced(&self, start: &Moment, neighbour: usize) -> Moment {
        /// Larger than what regular motions make of rounding errors, small enough for the neighbours to share the motion's fate.
        const BESIDE: f64 = 1e-6;
        let numbered = self.units.iter().zip(1..);
        let moves = numbered.map(|(unit, number)| {
            let opposite = neighbour.is_multiple_of(2) && u32::is_multiple_of(number, 2);
            let size = BESIDE * unit * unequal_part(number);
            if opposite { -size } else { size }
        });
        let state = start.state.iter().zip(moves).map(|(value, by)| value + by).collect();
        Moment { time: start.time, state }
    }
}

/// Number of neighbouring motions that are measured if a motion looks chaotic.
const NEIGHBOURS: usize = 2;

/// The cause for which a neighbouring motion yields no evidence.
fn cause_of(error: LyapunovError) -> Cause {
    match error {
        LyapunovError::Nothing(cause)
        | LyapunovError::Integration(IntegrationError::Stopped { cause, .. }) => cause,
        _ => Cause::Singularity,
    }
}

/// The range of the motion during the transient or ten intervals, whichever is longer, and the state after the transient.
fn survey(
    system: &System,
    start: &Moment,
    schedule: &Schedule,
    effort: &Effort,
    watch: &Watch<'_>,
) -> Result<(Extent, Moment), LyapunovError> {
    watch.begin(Stage::Motion { number: 0 }, Some(schedule.intervals));
    let mut extent = Extent::new(start.state.len());
    extent.include(&start.state);
    let settled = start.time + schedule.transient;
    let end = settled.max(start.time + 10.0 * schedule.interval);
    let mut solution = integrate_stepwise(system, start, &[settled, end], effort, |step| {
        extent.include(&step.state_at(step.end()));
        watch.flow()
    })?;
    Ok((extent, solution.samples.swap_remove(0)))
}
