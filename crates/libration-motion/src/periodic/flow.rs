//! The flow of a system, and the derivatives of its end with respect to its start and open parameters.

use super::jumps::{Arrival, Route, followed};
use super::modes::Modes;
use crate::taylor::{
    Effort, IntegrationError, Moment, Solution, StateLayout, Step, System, Trajectory, with_sensitivities,
};
use libration_numbers::algebra::Doubles;
use libration_numbers::expression::{Equation, Symbol, WithoutValue};
use libration_numbers::internals::expression::{Jet, Tape};
use std::ops::ControlFlow;

/// A system with some open parameters, with and without its variations.
#[derive(Debug)]
pub struct Flow {
    /// The order of the components of the state.
    pub layout: StateLayout,
    plain: System,
    /// The system with the derivatives by each parameter and by each component of the start appended.
    with_variations: System,
    /// The equations between the jumps of forces, if there are any.
    modes: Option<Modes>,
    rates: Tape,
    parameters: usize,
    most_steps: usize,
}

/// The end of a motion with its derivatives.
#[derive(Clone, Debug)]
pub struct Variations {
    /// The state at the end.
    pub end: Vec<f64>,
    /// Derivatives with respect to the components of the start, as the rows of a matrix.
    pub by_start: Vec<Vec<f64>>,
    /// Derivatives with respect to each parameter.
    pub by_parameters: Vec<Vec<f64>>,
    /// The rates of change of the state at the start and at the end; after a jump of a force there. NaN if a formula has no value.
    pub rates: [Vec<f64>; 2],
}

impl Flow {
    /// The flow of a system whose motions take at most `most_steps` steps.
    ///
    /// # Errors
    /// A symbol that is neither a component of the state, the time, nor one of the parameters.
    pub fn new(equation: &Equation, parameters: &[&str], most_steps: usize) -> Result<Self, WithoutValue> {
        let layout = StateLayout::new(equation);
        let plain = System::with_parameters(equation, parameters)?;
        let variations = with_sensitivities(equation, parameters, layout.numbers());
        let with_variations = System::with_parameters(&variations, parameters)?;
        let mut inputs = layout.symbols(equation.variables());
        inputs.extend(["t"].iter().chain(parameters).map(|name| Symbol::plain(name)));
        let rates = Tape::new(&equation.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        let modes = Modes::new(equation, parameters)?;
        Ok(Self { layout, plain, with_variations, modes, rates, parameters: parameters.len(), most_steps })
    }

    /// The same flow for thousands of motions, for which machine code is generated at the first step.
    #[must_use]
    pub fn for_many_steps(self) -> Self {
        let (plain, with_variations) = (self.plain.for_many_steps(), self.with_variations.for_many_steps());
        let modes = self.modes.map(Modes::for_many_steps);
        Self { plain, with_variations, modes, ..self }
    }

    /// The system without its variations.
    pub const fn system(&self) -> &System {
        &self.plain
    }

    /// Returns `true` if a force jumps, so that variations jump too.
    pub const fn has_jumps(&self) -> bool {
        self.modes.is_some()
    }

    /// The derivatives of the system as a tape in the state, the time and the parameters.
    pub const fn rates(&self) -> &Tape {
        &self.rates
    }

    /// The tolerance and the step limit of a motion.
    pub fn effort(&self, tolerance: f64) -> Effort {
        Effort { most_steps: self.most_steps, ..Effort::to_tolerance(tolerance) }
    }

    /// The motion between two times; `each` is called with each step and may stop the motion.
    ///
    /// # Errors
    /// A motion that cannot be integrated to its end, or that is stopped.
    pub fn motion(
        &self,
        state: &[f64],
        parameters: &[f64],
        [from, to]: [f64; 2],
        tolerance: f64,
        each: impl FnMut(&Step<'_>) -> ControlFlow<()>,
    ) -> Result<Solution, IntegrationError> {
        let start = Moment { time: from, state: state.to_vec() };
        let trajectory = Trajectory { start, parameters: parameters.to_vec(), times: &[to] };
        trajectory.integrate_stepwise(&self.plain, &self.effort(tolerance), each)
    }

    /// The end of a motion between two times with its derivatives.
    ///
    /// # Errors
    /// As [`motion`](Self::motion).
    pub fn variations(
        &self,
        state: &[f64],
        parameters: &[f64],
        times: [f64; 2],
        tolerance: f64,
        mut each: impl FnMut() -> ControlFlow<()>,
    ) -> Result<Variations, IntegrationError> {
        let end = self.followed(state, parameters, times, tolerance, &mut |_| each())?;
        Ok(self.taken_apart(end))
    }

    /// The end of a motion between two times with its derivatives, and the largest size of each derivative by the start along the motion, at the
    /// ends of the steps.
    ///
    /// # Errors
    /// As [`motion`](Self::motion).
    pub fn largest_variations(
        &self,
        state: &[f64],
        parameters: &[f64],
        times: [f64; 2],
        tolerance: f64,
        mut each: impl FnMut() -> ControlFlow<()>,
    ) -> Result<(Variations, Vec<Vec<f64>>), IntegrationError> {
        let numbers = self.layout.numbers();
        let mut largest = vec![vec![0.0_f64; numbers]; numbers];
        let end = self.followed(state, parameters, times, tolerance, &mut |step| {
            let here = step.map(|step| self.by_start(&step.state_at(step.end().min(times[1]))));
            for (largest, here) in largest.iter_mut().flatten().zip(here.iter().flatten().flatten()) {
                *largest = largest.max(here.abs());
            }
            each()
        })?;
        Ok((self.taken_apart(end), largest))
    }

    fn followed(
        &self,
        state: &[f64],
        parameters: &[f64],
        times: [f64; 2],
        tolerance: f64,
        each: &mut dyn FnMut(Option<&Step<'_>>) -> ControlFlow<()>,
    ) -> Result<Arrival, IntegrationError> {
        let numbers = self.layout.numbers();
        let mut start = vec![0.0; numbers * (1 + self.parameters + numbers)];
        for (number, value) in state.iter().enumerate() {
            start[self.address(number, 0)] = *value;
            start[self.address(number, 1 + self.parameters + number)] = 1.0;
        }
        if let Some(modes) = &self.modes {
            let route = Route { plain: &self.plain, effort: self.effort(tolerance), parameters, times };
            return followed(modes, route, (state, start), each);
        }
        let [from, to] = times;
        let start = Moment { time: from, state: start };
        let trajectory = Trajectory { start, parameters: parameters.to_vec(), times: &[to] };
        let effort = self.effort(tolerance);
        let solution =
            trajectory.integrate_stepwise(&self.with_variations, &effort, |step| each(Some(step)))?;
        let all = solution.end.state;
        let end: Vec<f64> = (0..numbers).map(|number| all[self.address(number, 0)]).collect();
        let rates = [(state, from), (&end[..], to)].map(|(state, time)| {
            self.rate(state, time, parameters).unwrap_or_else(|| vec![f64::NAN; numbers])
        });
        Ok(Arrival { all, rates })
    }

    /// The index of a component in the state with its variations: of the motion, copy 0, or of a derivative.
    fn address(&self, number: usize, copy: usize) -> usize {
        self.layout.place_in_copy(number, copy, self.parameters + self.layout.numbers())
    }

    fn taken_apart(&self, end: Arrival) -> Variations {
        let Arrival { all, rates } = end;
        let numbers = 0..self.layout.numbers();
        let of = |copy: usize| numbers.clone().map(|number| all[self.address(number, copy)]).collect();
        Variations {
            end: of(0),
            by_start: self.by_start(&all),
            by_parameters: (0..self.parameters).map(|number| of(1 + number)).collect(),
            rates,
        }
    }

    /// The derivatives by the start, as the rows of a matrix.
    fn by_start(&self, all: &[f64]) -> Vec<Vec<f64>> {
        let numbers = 0..self.layout.numbers();
        let entry = |number: usize, start: usize| all[self.address(number, 1 + self.parameters + start)];
        numbers.clone().map(|number| numbers.clone().map(|start| entry(number, start)).collect()).collect()
    }

    /// The time derivative of a state; `None` if a formula has no value.
    pub fn rate(&self, state: &[f64], time: f64, parameters: &[f64]) -> Option<Vec<f64>> {
        let inputs: Vec<f64> = state.iter().chain([&time]).chain(parameters).copied().collect();
        let jet = Jet::new(&Doubles, &self.rates, &inputs).ok()?;
        let mut rate = vec![0.0; state.len()];
        for coordinate in 0..self.layout.coordinates() {
            if let Some(velocity) = self.layout.velocity(coordinate) {
                rate[coordinate] = state[velocity];
            }
            rate[self.layout.driven(coordinate)] = jet.result(coordinate)[0];
        }
        Some(rate)
    }
}
