//! A driven system over its open parameters: how the end of a motion depends on its start and on them.

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

/// A system whose drive has a period at each value of its open parameters.
#[derive(Debug)]
pub(super) struct Family<'w> {
    pub(super) layout: StateLayout,
    pub(super) symmetry: Option<Symmetry>,
    law: DriveLaw,
    plain: System,
    /// Followed by the derivatives by each parameter and by each number of the start.
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
    /// And on each parameter, of which the time is a function.
    pub(super) by_parameters: Vec<Vec<f64>>,
}

/// The tolerance of steps from which places are computed, and another one that makes other errors.
pub(super) const TOLERANCES: [f64; 2] = [1e-16, 1e-15];
/// Steps of one motion.
const MOST_STEPS: usize = 100_000;

impl<'w> Family<'w> {
    pub(super) fn new(
        equation: &Equation,
        parameters: &[&str],
        ranges: &[[f64; 2]],
        watch: &'w Watch<'w>,
    ) -> Result<Self, NoBranch> {
        let layout = StateLayout::new(equation);
        let law = DriveLaw::new(equation, parameters)?;
        let plain = System::with_parameters(equation, parameters)?.for_many_steps();
        let derivatives = with_sensitivities(equation, parameters, layout.numbers());
        let with_derivatives = System::with_parameters(&derivatives, parameters)?.for_many_steps();
        let mut inputs = layout.symbols(equation.variables());
        inputs.extend(["t"].iter().chain(parameters).map(|name| Symbol::plain(name)));
        let rates = Tape::new(&equation.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        let symmetry = symmetry(&layout, &rates, &law, ranges);
        Ok(Self { layout, symmetry, law, plain, with_derivatives, rates, watch })
    }

    /// The time of a space.
    pub(super) fn duration(&self, space: Space, parameters: &[f64]) -> Option<f64> {
        self.law.period(parameters).map(|(period, _)| 0.5 * f64::from(space.half_periods) * period)
    }

    /// The image of a state with its derivatives; `None` where the motion cannot be followed.
    pub(super) fn image(
        &self,
        space: Space,
        state: &[f64],
        parameters: &[f64],
        tolerance: f64,
    ) -> Option<Image> {
        let (period, slopes) = self.law.period(parameters)?;
        let share = 0.5 * f64::from(space.half_periods);
        let (numbers, by) = (self.layout.numbers(), parameters.len());
        let place = |number: usize, copy: usize| self.layout.place_in_copy(number, copy, by + numbers);
        let mut start = vec![0.0; numbers * (1 + by + numbers)];
        for (number, value) in state.iter().enumerate() {
            start[place(number, 0)] = *value;
            start[place(number, 1 + by + number)] = 1.0;
        }
        let end = self.end(&self.with_derivatives, start, parameters, share * period, tolerance)?;
        let own: Vec<f64> = (0..numbers).map(|number| end[place(number, 0)]).collect();
        let rate = self.rate(&own, share * period, parameters)?;
        let sign = space.sign();
        let row =
            |number: usize| (0..numbers).map(|start| sign * end[place(number, 1 + by + start)]).collect();
        let by_parameter = |(number, slope): (usize, f64)| {
            (0..numbers).map(|it| sign * (end[place(it, 1 + number)] + share * slope * rate[it])).collect()
        };
        Some(Image {
            defect: own.iter().zip(state).map(|(end, start)| sign * end - start).collect(),
            map: (0..numbers).map(row).collect(),
            by_parameters: slopes.into_iter().enumerate().map(by_parameter).collect(),
        })
    }

    fn end(
        &self,
        system: &System,
        state: Vec<f64>,
        parameters: &[f64],
        duration: f64,
        tolerance: f64,
    ) -> Option<Vec<f64>> {
        let start = Moment { time: 0.0, state };
        let trajectory = Trajectory { start, parameters: parameters.to_vec(), times: &[duration] };
        let solution = trajectory.integrate_watched(system, &effort(tolerance), |_| self.watch.flow());
        Some(solution.ok()?.end.state).filter(|state| state.iter().all(|it| it.is_finite()))
    }

    /// The motion alone, step by step, and its end.
    pub(super) fn motion(
        &self,
        state: &[f64],
        parameters: &[f64],
        duration: f64,
        tolerance: f64,
    ) -> Result<(Vec<OwnedStep>, Vec<f64>), IntegrationError> {
        let start = Moment { time: 0.0, state: state.to_vec() };
        let trajectory = Trajectory { start, parameters: parameters.to_vec(), times: &[duration] };
        let mut steps = vec![];
        let solution = trajectory.integrate_watched(&self.plain, &effort(tolerance), |step| {
            steps.push(step.to_owned_step());
            self.watch.flow()
        })?;
        Ok((steps, solution.end.state))
    }

    /// The derivative of a state by the time.
    pub(super) fn rate(&self, state: &[f64], time: f64, parameters: &[f64]) -> Option<Vec<f64>> {
        let inputs: Vec<f64> = state.iter().chain([&time]).chain(parameters).copied().collect();
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
