//! Errors of all samples and events of a motion that is integrated forward, backward or in both directions.

use crate::taylor::{AcceptedStep, Effort, Gradients, Moment, MomentErrors, Occurrence, StateErrors, System};
use std::collections::HashMap;

/// The errors of the samples and events of a motion, created before the motion is integrated.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Effort, SampledErrors, System, integrate_both_ways};
/// use std::ops::ControlFlow;
/// let system = System::new(&"x'' = -x".parse()?)?;
/// let (start, effort) = (system.start(&[("x", 1.0)])?, Effort::to_tolerance(1e-12));
/// let times = [-50.0, 0.0, 50.0];
/// let mut errors = SampledErrors::new(&system, &start, &effort, &times, None);
/// let motion = integrate_both_ways(&system, &start, &times, &effort, |step| {
///     errors.follow(step);
///     ControlFlow::Continue(())
/// })?;
/// for sample in &motion.samples {
///     let error = errors.of_sample(sample.time).unwrap().state[0];
///     assert!((sample.state[0] - sample.time.cos()).abs() <= error && error < 1e-11);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SampledErrors<'a> {
    system: &'a System,
    start: Moment,
    effort: Effort,
    formulas: Option<Gradients>,
    /// The errors before the start, and those after it.
    sides: [Option<StateErrors>; 2],
    /// The times of the samples in ascending order.
    times: Vec<f64>,
    /// Errors by the bit patterns of the times.
    samples: HashMap<u64, MomentErrors>,
    /// Errors by the bit patterns of the times and the indices of the formulas.
    events: HashMap<(u64, usize), MomentErrors>,
}

impl<'a> SampledErrors<'a> {
    /// The errors of the state and of formulas at these times.
    #[must_use]
    pub fn new(
        system: &'a System,
        start: &Moment,
        effort: &Effort,
        times: &[f64],
        formulas: Option<Gradients>,
    ) -> Self {
        let (samples, events) = (HashMap::new(), HashMap::new());
        let mut times = times.to_vec();
        times.sort_by(f64::total_cmp);
        let (start, effort) = (start.clone(), *effort);
        let mut new = Self { system, start, effort, formulas, sides: [None, None], times, samples, events };
        let at_start = new.begun().at_start();
        let starts = new.times.iter().filter(|time| (*time - new.start.time).abs() <= 0.0);
        new.samples.extend(starts.map(|time| (time.to_bits(), at_start.clone())));
        new
    }

    /// Updates the errors with the next step.
    pub fn follow(&mut self, accepted: &AcceptedStep<'_>) {
        let step = accepted.step();
        let side = usize::from(step.end() > step.start());
        let mut errors = self.sides[side].take().unwrap_or_else(|| self.begun());
        errors.follow(accepted);
        let [low, high] = [step.start().min(step.end()), step.start().max(step.end())];
        let first = self.times.partition_point(|time| *time < low);
        for &time in self.times[first..].iter().take_while(|time| **time <= high) {
            if !self.samples.contains_key(&time.to_bits()) {
                let sample = Moment { time, state: step.state_at(time) };
                let of_sample = errors.of_sample(accepted, &sample);
                self.samples.extend(of_sample.map(|sample_errors| (time.to_bits(), sample_errors)));
            }
        }
        for event in accepted.events() {
            let of_event = errors.of_event(accepted, event);
            self.events
                .extend(of_event.map(|event_errors| ((event.time.to_bits(), event.event), event_errors)));
        }
        self.sides[side] = Some(errors);
    }

    /// The errors of the sample at a time; `None` if the motion is not determined.
    #[must_use]
    pub fn of_sample(&self, time: f64) -> Option<&MomentErrors> {
        self.samples.get(&time.to_bits())
    }

    /// The errors of an event; `None` if the motion is not determined.
    #[must_use]
    pub fn of_event(&self, event: &Occurrence) -> Option<&MomentErrors> {
        self.events.get(&(event.time.to_bits(), event.event))
    }

    /// The errors before or after the start, whichever part of the motion is determined for a shorter time, at the end of this part.
    #[must_use]
    pub fn worse(&self) -> Option<&StateErrors> {
        let reach = |errors: &&StateErrors| errors.determined_until().map_or(f64::INFINITY, f64::abs);
        self.sides.iter().flatten().min_by(|a, b| reach(a).total_cmp(&reach(b)))
    }

    fn begun(&self) -> StateErrors {
        let errors = StateErrors::new(self.system, &self.start, &self.effort);
        match &self.formulas {
            Some(formulas) => errors.with_formulas(formulas.clone()),
            None => errors,
        }
    }
}
