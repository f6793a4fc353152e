//! A motion as the steps of its integration.

use crate::periodic::{Extrema, extrema};
use crate::taylor::{
    DenseSolution, Effort, IntegrationError, Moment, OwnedStep, Solution, Step, System, integrate_stepwise,
};
use libration_numbers::internals::progress::Watch;
use libration_numbers::quadrature::gauss;
use libration_numbers::roots::{Tolerance, bisect};
use std::ops::ControlFlow;

/// Consecutive steps from one state to another.
#[derive(Clone, Debug)]
pub(super) struct Path {
    steps: DenseSolution,
    end: f64,
    /// `true` if the steps are the first half only, and the second half is the same motion reversed.
    there_and_back: bool,
}

impl Path {
    /// Steps from the time zero to the end.
    pub(super) fn of_steps(steps: Vec<OwnedStep>, end: f64) -> Self {
        Self { steps: steps.into(), end, there_and_back: false }
    }

    /// Steps from the time zero to rest, followed by the same way back, up to a time.
    pub(super) fn there_and_back(steps: Vec<OwnedStep>, end: f64) -> Self {
        Self { steps: steps.into(), end, there_and_back: true }
    }

    /// The motion from a moment to a time.
    pub(super) fn to_time(
        system: &System,
        start: &Moment,
        end: f64,
        effort: &Effort,
        watch: &Watch<'_>,
    ) -> Result<Self, IntegrationError> {
        let mut steps = DenseSolution::default();
        integrate_stepwise(system, start, &[end], effort, |step| {
            steps.push(step);
            watch.flow()
        })?;
        Ok(Self { steps, end, there_and_back: false })
    }

    pub(super) fn start_time(&self) -> f64 {
        self.steps.span().map_or(self.end, |[start, _]| start)
    }

    pub(super) fn end_time(&self) -> f64 {
        self.end
    }

    /// The states at the ends of all steps.
    pub(super) fn states(&self) -> impl Iterator<Item = Vec<f64>> {
        self.steps.steps().iter().map(|step| step.step().state_at(step.step().end().min(self.end)))
    }

    /// The least and the greatest value of a component.
    pub(super) fn extrema(&self, component: usize) -> Extrema {
        let [low, high] = extrema(self.steps.steps(), component, 0.0, self.end);
        // On the way back the velocity has the opposite sign.
        if self.there_and_back && component == 1 { [low.min(-high), high.max(-low)] } else { [low, high] }
    }

    /// Number of steps.
    pub(super) fn steps(&self) -> usize {
        self.steps.steps().len()
    }

    /// The largest rate of change of each component at the ends of the steps.
    pub(super) fn largest_rates(&self, components: usize) -> Vec<f64> {
        let rates = |component: usize| {
            let steps = self.steps.steps().iter();
            steps.map(move |step| step.step().rate_at(component, step.step().start()).abs())
        };
        (0..components).map(|component| rates(component).fold(0.0, f64::max)).collect()
    }

    /// The largest difference of each component from another path at the same fraction of the duration.
    pub(super) fn apart(&self, other: &Self) -> Vec<f64> {
        const LOOKS: u32 = 97;
        let at = |path: &Self, part: f64| {
            let [from, to] = [path.start_time(), path.end];
            path.state_at(from + part * (to - from))
        };
        let mut largest: Vec<f64> = vec![];
        for look in 0..=LOOKS {
            let part = f64::from(look) / f64::from(LOOKS);
            let [here, other] = [at(self, part), at(other, part)];
            largest.resize(here.len(), 0.0);
            for (largest, (a, b)) in largest.iter_mut().zip(here.iter().zip(&other)) {
                *largest = largest.max((a - b).abs());
            }
        }
        largest
    }

    /// The integral of a function of the state over the whole time, step by step.
    pub(super) fn integral(&self, f: impl Fn(&[f64]) -> f64) -> f64 {
        let over = |owned: &OwnedStep| {
            let step = owned.step();
            let duration = step.end().min(self.end) - step.start();
            duration * gauss(|part| f(&step.state_at(step.start() + part * duration))).value
        };
        self.steps.steps().iter().map(over).sum()
    }

    /// The state at a time: coordinates, then velocities.
    pub(super) fn state_at(&self, time: f64) -> Vec<f64> {
        if self.there_and_back && time > 0.5 * self.end {
            let [x, velocity] = self.stepped(self.end - time)[..] else { return vec![] };
            return vec![x, -velocity];
        }
        self.stepped(time)
    }

    fn stepped(&self, time: f64) -> Vec<f64> {
        self.steps.step_at(time).map_or_else(Vec::new, |step| step.state_at(time))
    }

    /// This path followed by another one that begins at its end.
    pub(super) fn followed_by(self, other: Self) -> Self {
        let steps = [self.steps.steps(), other.steps.steps()].concat();
        Self::of_steps(steps, other.end)
    }
}

/// Time beyond which a motion that has not turned never does: any noticeable force turns a motion within the square root of the largest number.
pub(super) const FAR: f64 = 1e100;

/// The motion from a moment until an event, which a function reports for a step with its time; `None` if it does not occur up to the last
/// horizon. The motion is followed to the first horizon, then twice as far, and so on: in a single step whose series seems to be a polynomial
/// without limit, the end of a branch of the force would be found only to a fraction of the horizon.
pub(super) fn until(
    system: &System,
    start: &Moment,
    horizons: [f64; 2],
    effort: &Effort,
    watch: &Watch<'_>,
    mut happens: impl FnMut(&Step<'_>) -> Option<f64>,
) -> Result<Option<Path>, IntegrationError> {
    let [first, last] = horizons;
    let (mut steps, mut time): (Vec<OwnedStep>, _) = (vec![], None);
    let (mut at, mut duration) = (start.clone(), first);
    while duration < last {
        let effort = Effort { most_steps: effort.most_steps.saturating_sub(steps.len()), ..*effort };
        let outcome = integrate_stepwise(system, &at, &[start.time + duration], &effort, |step| {
            steps.push(step.to_owned_step());
            time = happens(step);
            let goes_on = watch.flow();
            if time.is_some() { ControlFlow::Break(()) } else { goes_on }
        });
        match (time, outcome) {
            (Some(end), _) => return Ok(Some(Path::of_steps(steps, end))),
            (None, Ok(Solution { end, .. })) => at = end,
            (None, Err(error)) => return Err(error),
        }
        duration *= 2.0;
    }
    Ok(None)
}

/// The time at which a state component first changes its sign in a step, to the last bit; `None` if it
/// has the same sign at both ends. If the step begins at zero, the sign shortly afterwards counts.
pub(super) fn sign_change(step: &Step<'_>, number: usize) -> Option<f64> {
    let changes = |[before, after]: [f64; 2]| after == 0.0 || (before > 0.0) != (after > 0.0);
    zero_in(step, |time| step.state_at(time)[number], changes)
}

/// The time of the first maximum of a coordinate in a step, to the last bit, as for [`sign_change`] of its rate of change. There may be a
/// minimum before it: between kinks of a force a step may be a whole swing.
pub(super) fn maximum_in(step: &Step<'_>, coordinate: usize) -> Option<f64> {
    let falls = |[before, after]: [f64; 2]| before > 0.0 && after <= 0.0;
    zero_in(step, |time| step.speeds_at(time)[coordinate], falls)
}

fn zero_in(step: &Step<'_>, value: impl Fn(f64) -> f64, is_wanted: impl Fn([f64; 2]) -> bool) -> Option<f64> {
    /// Fraction of the step that is skipped after a zero at its beginning, which belongs to the previous step.
    const SOON: f64 = 1e-3;
    /// Number of parts into which a step is divided, since it may be longer than half a wave: for an
    /// oscillator, whose series converge everywhere, it is 4 radians. A quarter of a step is shorter.
    const PARTS: u32 = 4;
    let (mut before, after) = (step.start(), step.end());
    if value(before) == 0.0 {
        before += SOON * (after - before);
    }
    let part = |number: u32| before + (after - before) * f64::from(number) / f64::from(PARTS);
    let mut parts =
        (0..PARTS).map(|number| [part(number), if number + 1 < PARTS { part(number + 1) } else { after }]);
    let [from, to] = parts.find(|ends| is_wanted(ends.map(&value)))?;
    let was_positive = value(from) > 0.0;
    let [_, zero] = bisect([from, to], Tolerance::LAST_BIT, |time| {
        let value = value(time);
        value != 0.0 && (value > 0.0) == was_positive
    });
    Some(zero)
}
