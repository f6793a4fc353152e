//! From a state to the states at given times.

use std::ops::ControlFlow;

use super::branches::Branches;
use super::expander::Expander;
use super::{Cause, Effort, IntegrationError, Step, System};
use crate::double_double::DoubleDouble;

/// A time and the state at it: coordinates, then velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// When.
    pub time: f64,
    /// The numbers that [`System::state_names`] names.
    pub state: Vec<f64>,
}

/// What an integration has computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The states at the times asked for, as far as it came.
    pub samples: Vec<Moment>,
    /// The last state, at the end of the last step.
    pub end: Moment,
    /// How many steps it took.
    pub steps: usize,
}

/// Integrates a system from a state to the states at some times, which are all after the start or all before it, one
/// behind the other. `watch` sees each step and may stop the integration.
///
/// # Accuracy
/// Each step errs by less than the tolerance of [`Effort`]. What becomes of these errors is a matter of the system: the
/// pendulum's phase gathers them like the square of the time, near an unstable equilibrium they grow exponentially.
/// States go in two words from step to step, and times are exact, so that sums of many steps lose nothing; but the
/// accelerations see each coordinate rounded to one word, of which an angle of a thousand turns loses four digits.
///
/// Where the argument of an absolute value changes its sign the step ends, at the nearest `f64`, and the other branch
/// goes on. Other formulas that are not analytic, such as √(x²) at zero, stop the integration.
///
/// # Errors
/// A start, times or tolerances that cannot be; a singularity, the step limit, or an interruption, with what was
/// computed until then.
///
/// # Examples
/// ```
/// use libration::taylor::{Effort, Moment, System, integrate};
/// use std::ops::ControlFlow;
/// let system = System::new(&"theta'' + 0.1 theta' + sin(theta) = 0".parse()?)?;
/// let start = Moment { time: 0.0, state: vec![1.0, 0.0] };
/// let solution = integrate(&system, &start, &[1.0, 20.0], &Effort::to_tolerance(1e-15), |_| ControlFlow::Continue(()))?;
/// assert!((solution.samples[0].state[0] - 0.6129128065918317).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate(
    system: &System,
    start: &Moment,
    times: &[f64],
    effort: &Effort,
    mut watch: impl FnMut(&Step) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    check(system, start, times, effort)?;
    let mut motion = Integration::new(system, start, *effort);
    let mut samples = Vec::with_capacity(times.len());
    let outcome = fill(&mut samples, times, &mut motion, &mut watch);
    let solution = Solution { samples, end: motion.moment(), steps: motion.steps };
    match outcome {
        Ok(()) => Ok(solution),
        Err(cause) => Err(IntegrationError::Stopped { cause, solution: Box::new(solution) }),
    }
}

/// The states at all times, step by step.
fn fill(
    samples: &mut Vec<Moment>,
    times: &[f64],
    motion: &mut Integration,
    watch: &mut impl FnMut(&Step) -> ControlFlow<()>,
) -> Result<(), Cause> {
    while let Some(&last) = times.last().filter(|_| samples.len() < times.len()) {
        let step = motion.advance(last)?;
        let inside = times[samples.len()..].iter().take_while(|&&time| step.reaches(time));
        samples.extend(inside.map(|&time| Moment { time, state: step.state_at(time) }));
        if watch(step).is_break() && samples.len() < times.len() {
            return Err(Cause::Interrupted);
        }
    }
    Ok(())
}

fn check(system: &System, start: &Moment, times: &[f64], effort: &Effort) -> Result<(), IntegrationError> {
    let (got, wanted) = (start.state.len(), 2 * system.coordinates());
    if got != wanted {
        return Err(IntegrationError::StateLength { got, wanted });
    }
    if let Some(&value) = start.state.iter().chain([&start.time]).find(|value| !value.is_finite()) {
        return Err(IntegrationError::StartNotFinite(value));
    }
    if let Some(&time) = times.iter().find(|time| !time.is_finite()) {
        return Err(IntegrationError::TimeNotFinite(time));
    }
    let backward = times.last().is_some_and(|&last| last < start.time);
    let pairs = [start.time].into_iter().chain(times.iter().copied()).zip(times.iter().copied());
    if let Some((before, after)) = pairs.into_iter().find(|(a, b)| if backward { b > a } else { b < a }) {
        return Err(IntegrationError::TimesNotInOrder { before, after });
    }
    let Effort { relative, absolute, .. } = *effort;
    if effort.is_possible() { Ok(()) } else { Err(IntegrationError::Tolerance { relative, absolute }) }
}

/// An integration under way: where it is, and the step that led there.
struct Integration<'a> {
    expander: Expander<'a>,
    branches: Branches,
    effort: Effort,
    time: f64,
    state: Vec<DoubleDouble>,
    step: Step,
    steps: usize,
}

impl<'a> Integration<'a> {
    fn new(system: &'a System, start: &Moment, effort: Effort) -> Self {
        Self {
            expander: Expander::new(system, effort.order()),
            branches: Branches::new(system.moduli()),
            effort,
            time: start.time,
            state: start.state.iter().map(|&value| DoubleDouble::from(value)).collect(),
            step: Step::new(start.state.len()),
            steps: 0,
        }
    }

    /// Takes a step towards a time, at most up to it.
    fn advance(&mut self, last: f64) -> Result<&Step, Cause> {
        if self.steps >= self.effort.most_steps {
            return Err(Cause::StepLimit);
        }
        self.step.begin(self.time, &self.state);
        self.branches.settle(&mut self.expander, &mut self.step, last < self.time)?;
        self.step.end = self.end_towards(last)?;
        self.branches.cut(&self.expander, &mut self.step);
        let state: Vec<DoubleDouble> = self.step.two_word_state_at(self.step.end).collect();
        if !state.iter().all(|value| value.is_finite()) {
            return Err(Cause::Singularity);
        }
        (self.time, self.state) = (self.step.end, state);
        self.steps += 1;
        Ok(&self.step)
    }

    /// Where the step ends: always at an `f64`, so that times are exact.
    fn end_towards(&mut self, last: f64) -> Result<f64, Cause> {
        let (start, length) = (self.step.start, self.effort.step_length(&self.step.series));
        if length == f64::INFINITY {
            return self.end_of_polynomials(last);
        }
        let remaining = last - start;
        if length >= remaining.abs() {
            return Ok(last);
        }
        let end = start + length.copysign(remaining);
        let shortest = 8.0 * f64::EPSILON * start.abs();
        if (end - start).abs() > shortest { Ok(end) } else { Err(Cause::StepUnderflow) }
    }

    /// The farthest end up to which series that seem to be polynomials obey the equation of motion.
    fn end_of_polynomials(&mut self, last: f64) -> Result<f64, Cause> {
        const HALVINGS: usize = 1100;
        let start = self.step.start;
        let ends = std::iter::successors(Some(last), |end| Some(start + 0.5 * (end - start)));
        let mut ends = ends.take(HALVINGS).take_while(|&end| (end - start).abs() > 0.0);
        let bound = self.effort.relative.sqrt();
        let found = ends.find(|&end| self.branches.defect(&mut self.expander, &self.step, end) <= bound);
        let end = found.ok_or(Cause::StepUnderflow)?;
        self.branches.expand(&mut self.expander, &mut self.step)?;
        Ok(end)
    }

    fn moment(&self) -> Moment {
        Moment { time: self.time, state: self.state.iter().map(|value| value.to_f64()).collect() }
    }
}
