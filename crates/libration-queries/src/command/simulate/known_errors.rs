//! The errors of a motion that is written when it is known.

use super::motion::SimulatedMotion;
use libration::taylor::{AcceptedStep, Moment, Occurrence, StateErrors, System};
use std::collections::HashMap;

/// The errors of all samples and events.
#[derive(Debug)]
pub(super) struct KnownErrors {
    /// The errors before the start and after it.
    sides: [Option<StateErrors>; 2],
    /// Errors of the samples, by the bits of their times.
    samples: HashMap<u64, Vec<f64>>,
    /// Errors of the events, by the bits of their times and the numbers of the formulas.
    events: HashMap<(u64, usize), Moment>,
    /// Not numbers.
    none: Moment,
}

impl KnownErrors {
    pub(super) fn new(motion: &SimulatedMotion) -> Self {
        let start = motion.beginning();
        let mut samples = HashMap::new();
        let zero = vec![0.0; motion.own(&start).state.len()];
        samples.extend(
            motion.times.iter().filter(|time| *time == 0.0).map(|time| (time.to_bits(), zero.clone())),
        );
        Self { sides: [None, None], samples, events: HashMap::new(), none: motion.own_event_error(None) }
    }

    pub(super) fn follow(&mut self, accepted: &AcceptedStep<'_>, motion: &SimulatedMotion, system: &System) {
        let step = accepted.step();
        let side = usize::from(step.end() > step.start());
        let new = || StateErrors::new(system, &motion.beginning(), &motion.effort());
        let errors = self.sides[side].get_or_insert_with(new);
        errors.follow(accepted);
        let [low, high] = [step.start().min(step.end()), step.start().max(step.end())];
        for time in motion.times.iter().filter(|time| (low..=high).contains(time) && *time != 0.0) {
            let error = errors.at(&Moment { time, state: step.state_at(time) });
            self.samples.entry(time.to_bits()).or_insert_with(|| motion.own_error(error));
        }
        for event in accepted.events() {
            let error = motion.own_event_error(errors.of_event(accepted, event));
            self.events.insert((event.time.to_bits(), event.event), error);
        }
    }

    /// The errors of the side that is determined for less time.
    pub(super) fn worse(&self) -> Option<&StateErrors> {
        let reach = |errors: &&StateErrors| errors.determined_until().map_or(f64::INFINITY, f64::abs);
        self.sides.iter().flatten().min_by(|a, b| reach(a).total_cmp(&reach(b)))
    }

    pub(super) fn of_sample(&self, time: f64) -> Vec<f64> {
        self.samples.get(&time.to_bits()).unwrap_or(&self.none.state).clone()
    }

    pub(super) fn of_event(&self, event: &Occurrence) -> Moment {
        self.events.get(&(event.time.to_bits(), event.event)).unwrap_or(&self.none).clone()
    }
}
