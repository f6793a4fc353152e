//! A driven system over one parameter: how the end of a motion depends on its start and on the parameter.

use super::drive_law::DriveLaw;
use super::error::NoBranch;
use super::space::{Space, Symmetry};
use super::symmetry::symmetry;
use crate::algebra::Doubles;
use crate::expression::{Equation, Jet, Symbol, Tape};
use crate::taylor::{
    Effort, IntegrationError, Moment, OwnedStep, StateLayout, System, Trajectory, with_sensitivities,
};
use crate::watch::Watch;

/// A system whose drive has a period at each value of a parameter.
#[derive(Debug)]
pub(super) struct Family<'w> {
    pub(super) layout: StateLayout,
    pub(super) symmetry: Option<Symmetry>,
    law: DriveLaw,
    plain: System,
    /// Followed by the derivatives by the parameter and by each number of the start.
    with_derivatives: System,
    rates: Tape,
    pub(super) watch: &'w Watch<'w>,
}

/// Where a motion leads in the time of its space, its mirror image where the space has one.
#[derive(Clone, Debug)]
pub(super) struct Image {
    /// What its end misses of the start.
    pub(super) defect: Vec<f64>,
    /// How the end depends on the start, by rows.
    pub(super) map: Vec<Vec<f64>>,
    /// And on the parameter, of which the time is a function.
    pub(super) by_parameter: Vec<f64>,
}

/// The tolerance of steps from which places are computed, and another one that makes other errors.
pub(super) const TOLERANCES: [f64; 2] = [1e-16, 1e-15];
/// Steps of one motion.
const MOST_STEPS: usize = 100_000;

impl<'w> Family<'w> {
    pub(super) fn new(
        equation: &Equation,
        parameter: &str,
        range: [f64; 2],
        watch: &'w Watch<'w>,
    ) -> Result<Self, NoBranch> {
        let layout = StateLayout::new(equation);
        let law = DriveLaw::new(equation, parameter)?;
        let plain = System::with_parameters(equation, &[parameter])?;
        let derivatives = with_sensitivities(equation, &[parameter], layout.numbers());
        let with_derivatives = System::with_parameters(&derivatives, &[parameter])?;
        let mut inputs = layout.symbols(equation.variables());
        inputs.extend([Symbol::plain("t"), Symbol::plain(parameter)]);
        let rates = Tape::new(&equation.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        let symmetry = symmetry(&layout, &rates, &law, range);
        Ok(Self { layout, symmetry, law, plain, with_derivatives, rates, watch })
    }

    /// The time of a space, and its derivative by the parameter.
    pub(super) fn duration(&self, space: Space, parameter: f64) -> Option<[f64; 2]> {
        let half_periods = f64::from(space.half_periods);
        self.law.period(parameter).map(|period| period.map(|it| 0.5 * half_periods * it))
    }

    /// The image of a state with its derivatives; `None` where the motion cannot be followed.
    pub(super) fn image(&self, space: Space, state: &[f64], parameter: f64, tolerance: f64) -> Option<Image> {
        let [duration, slope] = self.duration(space, parameter)?;
        let numbers = self.layout.numbers();
        let place = |number: usize, copy: usize| self.layout.place_in_copy(number, copy, 1 + numbers);
        let mut start = vec![0.0; numbers * (2 + numbers)];
        for (number, value) in state.iter().enumerate() {
            start[place(number, 0)] = *value;
            start[place(number, 2 + number)] = 1.0;
        }
        let end = self.end(&self.with_derivatives, start, parameter, duration, tolerance)?;
        let own: Vec<f64> = (0..numbers).map(|number| end[place(number, 0)]).collect();
        let rate = self.rate(&own, duration, parameter)?;
        let sign = space.sign();
        let row = |number: usize| (0..numbers).map(|by| sign * end[place(number, 2 + by)]).collect();
        Some(Image {
            defect: own.iter().zip(state).map(|(end, start)| sign * end - start).collect(),
            map: (0..numbers).map(row).collect(),
            by_parameter: (0..numbers)
                .map(|number| sign * (end[place(number, 1)] + slope * rate[number]))
                .collect(),
        })
    }

    fn end(
        &self,
        system: &System,
        state: Vec<f64>,
        parameter: f64,
        duration: f64,
        tolerance: f64,
    ) -> Option<Vec<f64>> {
        let start = Moment { time: 0.0, state };
        let trajectory = Trajectory { start, parameters: vec![parameter], times: &[duration] };
        let solution = trajectory.integrate_watched(system, &effort(tolerance), |_| self.watch.flow());
        Some(solution.ok()?.end.state).filter(|state| state.iter().all(|it| it.is_finite()))
    }

    /// The motion alone, step by step, and its end.
    pub(super) fn motion(
        &self,
        state: &[f64],
        parameter: f64,
        duration: f64,
        tolerance: f64,
    ) -> Result<(Vec<OwnedStep>, Vec<f64>), IntegrationError> {
        let start = Moment { time: 0.0, state: state.to_vec() };
        let trajectory = Trajectory { start, parameters: vec![parameter], times: &[duration] };
        let mut steps = vec![];
        let solution = trajectory.integrate_watched(&self.plain, &effort(tolerance), |step| {
            steps.push(step.to_owned_step());
            self.watch.flow()
        })?;
        Ok((steps, solution.end.state))
    }

    /// The derivative of a state by the time.
    fn rate(&self, state: &[f64], time: f64, parameter: f64) -> Option<Vec<f64>> {
        let inputs: Vec<f64> = state.iter().copied().chain([time, parameter]).collect();
        let jet = Jet::new(&Doubles, &self.rates, &inputs).ok()?;
        let coordinates = 0..self.layout.coordinates();
        let mut rate = vec![0.0; state.len()];
        for coordinate in coordinates {
            if let Some(velocity) = self.layout.velocity(coordinate) {
                rate[coordinate] = state[velocity];
            }
            rate[self.layout.driven(coordinate)] = jet.result(coordinate)[0];
        }
        Some(rate)
    }
}

fn effort(tolerance: f64) -> Effort {
    Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(tolerance) }
}
