//! A motion that is known at every time.

use std::ops::ControlFlow;

use crate::taylor::{Effort, IntegrationError, Moment, OwnedStep, Step, System, integrate_stepwise};

/// A motion as the polynomials of all its steps, from which the state at every time between its ends follows.
///
/// The solution takes 8 bytes for each coefficient: some 30 coefficients for each state component, in each step, at the tolerance 1e-15.
#[derive(Clone, Debug, Default)]
pub struct DenseSolution {
    steps: Vec<OwnedStep>,
}

/// Integrates like [`integrate`](crate::taylor::integrate()), from a state to a time, and stores all steps.
///
/// # Errors
/// As [`integrate`](crate::taylor::integrate()).
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Effort, System, integrate_dense};
/// let system = System::new(&"x'' + x = 0".parse()?)?;
/// let start = system.start(&[("x", 1.0)])?;
/// let motion = integrate_dense(&system, &start, 10.0, &Effort::to_tolerance(1e-15))?;
/// let state = motion.state_at(std::f64::consts::PI).ok_or("it ends before")?;
/// assert!((state[0] + 1.0).abs() < 1e-15);
/// assert_eq!(motion.state_at(11.0), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate_dense(
    system: &System,
    start: &Moment,
    end: f64,
    effort: &Effort,
) -> Result<DenseSolution, IntegrationError> {
    let mut motion = DenseSolution::default();
    integrate_stepwise(system, start, &[end], effort, |step| {
        motion.push(step);
        ControlFlow::Continue(())
    })?;
    Ok(motion)
}

impl DenseSolution {
    /// Adds the step that follows.
    pub fn push(&mut self, step: &Step<'_>) {
        self.steps.push(step.to_owned_step());
    }

    /// The times of the start and of the end; `None` if there are no steps.
    #[must_use]
    pub fn span(&self) -> Option<[f64; 2]> {
        Some([self.steps.first()?.step().start(), self.steps.last()?.step().end()])
    }

    /// The steps.
    #[must_use]
    pub fn steps(&self) -> &[OwnedStep] {
        &self.steps
    }

    /// Coordinates, then velocities, at a time; `None` before the start or after the end.
    ///
    /// # Accuracy
    /// That of the states at the ends of the steps.
    #[must_use]
    pub fn state_at(&self, time: f64) -> Option<Vec<f64>> {
        let [start, end] = self.span()?;
        let (low, high) = (start.min(end), start.max(end));
        if !(low..=high).contains(&time) {
            return None;
        }
        Some(self.step_at(time)?.state_at(time))
    }

    /// The step that contains the time, or the nearest one.
    pub(crate) fn step_at(&self, time: f64) -> Option<Step<'_>> {
        let [start, end] = self.span()?;
        let index = self.steps.partition_point(|step| match end < start {
            true => step.step().end() > time,
            false => step.step().end() < time,
        });
        self.steps.get(index).or(self.steps.last()).map(OwnedStep::step)
    }
}

impl From<Vec<OwnedStep>> for DenseSolution {
    /// The solution that consists of consecutive steps.
    fn from(steps: Vec<OwnedStep>) -> Self {
        Self { steps }
    }
}
