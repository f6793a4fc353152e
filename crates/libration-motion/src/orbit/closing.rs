//! One round from a state, and how its end depends on its start.

use super::error::NoOrbit;
use super::near::OrbitGuess;
use super::path::{Path, sign_change, until};
use crate::taylor::{Effort, IntegrationError, Moment, StateLayout, System, with_tangents};
use libration_numbers::algebra::Doubles;
use libration_numbers::watch::Watch;
use libration_numbers::{
    expression::{Equation, Symbol},
    internals::expression::{Jet, Tape},
};
use std::f64::consts::TAU;

/// A system together with its small deviations.
#[derive(Debug)]
pub(super) struct Rounds<'w> {
    plain: System,
    /// One deviation for each number of the state.
    with_deviations: System,
    derivatives: Tape,
    pub(super) layout: StateLayout,
    watch: &'w Watch<'w>,
}

/// One round with its derivatives.
#[derive(Debug)]
pub(super) struct Round {
    pub(super) path: Path,
    /// End minus start.
    pub(super) defect: Vec<f64>,
    /// How the end depends on the start, by rows.
    pub(super) monodromy: Vec<Vec<f64>>,
    /// How the end depends on the duration.
    pub(super) rate: Vec<f64>,
}

/// What moves by less than this part of its distance from zero is measured by that.
const LEAST_SIZE: f64 = 1e-5;
/// Steps of one round; van der Pol's oscillator with the strength 1000 takes 3e5.
const MOST_STEPS: usize = 1_000_000;

impl<'w> Rounds<'w> {
    pub(super) fn new(equation: &Equation, watch: &'w Watch<'w>) -> Result<Self, NoOrbit> {
        let plain = System::new(equation)?;
        let layout = StateLayout::new(equation);
        let with_deviations = System::new(&with_tangents(equation, layout.numbers()))?;
        let mut inputs = layout.symbols(equation.variables());
        inputs.push(Symbol::plain("t"));
        let derivatives = Tape::new(&equation.derivatives().iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { plain, with_deviations, derivatives, layout, watch })
    }

    /// The motion alone.
    pub(super) fn path(
        &self,
        state: &[f64],
        duration: f64,
        tolerance: f64,
    ) -> Result<Path, IntegrationError> {
        let start = Moment { time: 0.0, state: state.to_vec() };
        Path::to_time(&self.plain, &start, duration, &effort(tolerance), self.watch)
    }

    /// The motion of one coordinate with a velocity from a maximum to the next, which is expected after about the period of the guess.
    pub(super) fn turn(&self, start: &OrbitGuess, tolerance: f64) -> Result<Option<Path>, IntegrationError> {
        let horizons = [1.5 * start.period, 2.0 * start.period];
        let start = Moment { time: 0.0, state: start.state.clone() };
        until(&self.plain, &start, horizons, &effort(tolerance), self.watch, |step| {
            let velocity = self.layout.driven(0);
            let rises = step.state_at(step.start())[velocity] > 0.0;
            sign_change(step, velocity).filter(|_| rises)
        })
    }

    /// The motion with its deviations.
    pub(super) fn round(&self, state: &[f64], duration: f64) -> Result<Round, NoOrbit> {
        let path = self.path(state, duration, 1e-17)?;
        let end = path.state_at(duration);
        let monodromy = self.monodromy(state, duration)?;
        let rate = self.rate(&end, duration)?;
        let defect = end.iter().zip(state).map(|(end, start)| end - start).collect();
        Ok(Round { path, defect, monodromy, rate })
    }

    /// The number of the state that keeps its value while a cycle is closed that begins at a maximum of the first coordinate: the
    /// velocity, and without one what moves fastest there, since the coordinate itself stands still.
    pub(super) fn held_at_maximum(&self, guess: &OrbitGuess) -> Result<usize, NoOrbit> {
        if let Some(velocity) = self.layout.velocity(0) {
            return Ok(velocity);
        }
        let round = self.round(&guess.state, guess.period)?;
        let rate = self.rate(&guess.state, 0.0)?;
        let paces: Vec<f64> = rate
            .iter()
            .zip(round.sizes(&self.layout, guess))
            .map(|(rate, size)| (rate / size).abs())
            .collect();
        let fastest = (0..paces.len()).max_by(|a, b| paces[*a].total_cmp(&paces[*b]));
        Ok(fastest.unwrap_or(0))
    }

    /// How the state after a time depends on that at the start, by rows.
    fn monodromy(&self, state: &[f64], duration: f64) -> Result<Vec<Vec<f64>>, NoOrbit> {
        let numbers = self.layout.numbers();
        let place =
            |deviation: usize, number: usize| self.layout.place_in_copy(number, 1 + deviation, numbers);
        let mut start = vec![0.0; numbers * (1 + numbers)];
        for (number, value) in state.iter().enumerate() {
            start[place(number, number)] = 1.0;
            start[self.layout.place_in_copy(number, 0, numbers)] = *value;
        }
        let start = Moment { time: 0.0, state: start };
        let end = Path::to_time(&self.with_deviations, &start, duration, &effort(1e-15), self.watch)?
            .state_at(duration);
        Ok((0..numbers).map(|row| (0..numbers).map(|column| end[place(column, row)]).collect()).collect())
    }

    /// The derivative of the state by the time.
    pub(super) fn rate(&self, state: &[f64], time: f64) -> Result<Vec<f64>, NoOrbit> {
        let inputs: Vec<f64> = state.iter().copied().chain([time]).collect();
        let refusal = |_| NoOrbit::Start { state: state.to_vec(), wanted: self.layout.numbers() };
        let jet = Jet::new(&Doubles, &self.derivatives, &inputs).map_err(refusal)?;
        let mut rate = vec![0.0; state.len()];
        for coordinate in 0..self.layout.coordinates() {
            if let Some(velocity) = self.layout.velocity(coordinate) {
                rate[coordinate] = state[velocity];
            }
            rate[self.layout.driven(coordinate)] = jet.result(coordinate)[0];
        }
        Ok(rate)
    }
}

impl Round {
    /// How far each number of the state goes on the way, in which its errors are measured: at least [`LEAST_SIZE`] of the
    /// coordinate, and as far as the others of its kind if it hardly moves at all.
    pub(super) fn sizes(&self, layout: &StateLayout, start: &OrbitGuess) -> Vec<f64> {
        let pace = TAU / start.period;
        let least = |number: usize| {
            let coordinate = layout.driving(number).unwrap_or(number);
            let place = LEAST_SIZE * start.state[coordinate].abs();
            if layout.is_velocity(number) { place * pace } else { place }
        };
        let ranges = self.ranges(layout.numbers());
        let (places, velocities) = ranges.split_at(layout.coordinates());
        let kinds = [(0, places), (layout.coordinates(), velocities)].into_iter();
        let sizes = kinds.flat_map(|(first, ranges)| {
            let largest = ranges.iter().copied().fold(0.0, f64::max);
            let size = move |range: f64| if range > 1e-9 * largest { range } else { largest };
            ranges.iter().enumerate().map(move |(i, range)| size(*range).max(least(first + i)))
        });
        sizes.map(|size| if size > 0.0 { size } else { 1.0 }).collect()
    }

    /// Between the largest and the least value of each number at the ends of the steps.
    fn ranges(&self, numbers: usize) -> Vec<f64> {
        let states: Vec<Vec<f64>> = self.path.states().collect();
        let range = |number: usize| {
            let values = states.iter().map(|state| state[number]);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            (high - low).max(0.0)
        };
        (0..numbers).map(range).collect()
    }
}

fn effort(tolerance: f64) -> Effort {
    Effort { most_steps: MOST_STEPS, ..Effort::to_tolerance(tolerance) }
}
