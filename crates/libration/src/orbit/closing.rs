//! One round from a state, and how its end depends on its start.

use super::error::NoOrbit;
use super::near::OrbitGuess;
use super::path::{Path, sign_change, until};
use crate::algebra::Doubles;
use crate::expression::{Equation, Jet, Symbol, Tape};
use crate::taylor::{Effort, IntegrationError, Moment, System, with_tangents};
use crate::watch::Watch;
use std::f64::consts::TAU;

/// A system together with its small deviations.
#[derive(Debug)]
pub(super) struct Rounds<'w> {
    plain: System,
    /// One deviation for each number of the state.
    with_deviations: System,
    accelerations: Tape,
    pub(super) coordinates: usize,
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
        let coordinates = equation.variables().len();
        let plain = System::new(equation)?;
        let with_deviations = System::new(&with_tangents(equation, 2 * coordinates))?;
        let names = equation.variables().iter().map(|name| Symbol::plain(name));
        let mut inputs: Vec<Symbol> = [0, 1]
            .into_iter()
            .flat_map(|primes| names.clone().map(move |symbol| symbol.with_primes(primes)))
            .collect();
        inputs.push(Symbol::plain("t"));
        let accelerations = Tape::new(&equation.accelerations().iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { plain, with_deviations, accelerations, coordinates, watch })
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

    /// The motion from a maximum of the first coordinate to the next, which is expected after about the period of the guess.
    pub(super) fn turn(&self, start: &OrbitGuess, tolerance: f64) -> Result<Option<Path>, IntegrationError> {
        let horizons = [1.5 * start.period, 2.0 * start.period];
        let start = Moment { time: 0.0, state: start.state.clone() };
        until(&self.plain, &start, horizons, &effort(tolerance), self.watch, |step| {
            let rises = step.state_at(step.start())[self.coordinates] > 0.0;
            sign_change(step, self.coordinates).filter(|_| rises)
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

    /// The state of the system with deviations is x, δ₁x, δ₂x, …, x′, δ₁x′, δ₂x′, ….
    fn monodromy(&self, state: &[f64], duration: f64) -> Result<Vec<Vec<f64>>, NoOrbit> {
        let (n, numbers) = (self.coordinates, 2 * self.coordinates);
        let place = |deviation: usize, number: usize| {
            let half = if number < n { 0 } else { n * (1 + numbers) };
            half + n * (1 + deviation) + number % n
        };
        let mut start = vec![0.0; 2 * n * (1 + numbers)];
        for number in 0..numbers {
            start[place(number, number)] = 1.0;
        }
        start[..n].copy_from_slice(&state[..n]);
        start[n * (1 + numbers)..][..n].copy_from_slice(&state[n..]);
        let start = Moment { time: 0.0, state: start };
        let end = Path::to_time(&self.with_deviations, &start, duration, &effort(1e-15), self.watch)?
            .state_at(duration);
        Ok((0..numbers).map(|row| (0..numbers).map(|column| end[place(column, row)]).collect()).collect())
    }

    /// The derivative of the state by the time.
    fn rate(&self, state: &[f64], time: f64) -> Result<Vec<f64>, NoOrbit> {
        let inputs: Vec<f64> = state.iter().copied().chain([time]).collect();
        let refusal = |_| NoOrbit::Start { state: state.to_vec(), wanted: 2 * self.coordinates };
        let jet = Jet::new(&Doubles, &self.accelerations, &inputs).map_err(refusal)?;
        let accelerations = (0..self.coordinates).map(|i| jet.result(i)[0]);
        Ok(state[self.coordinates..].iter().copied().chain(accelerations).collect())
    }
}

impl Round {
    /// How far each number of the state goes on the way, in which its errors are measured: at least [`LEAST_SIZE`] of the
    /// coordinate, and as far as the others of its kind if it hardly moves at all.
    pub(super) fn sizes(&self, start: &OrbitGuess) -> Vec<f64> {
        let numbers = start.state.len();
        let pace = TAU / start.period;
        let least = |number: usize| {
            let place = LEAST_SIZE * start.state[number % (numbers / 2)].abs();
            if number < numbers / 2 { place } else { place * pace }
        };
        let ranges = self.ranges(numbers);
        let kinds = ranges.chunks((numbers / 2).max(1)).enumerate();
        let sizes = kinds.flat_map(|(kind, ranges)| {
            let largest = ranges.iter().copied().fold(0.0, f64::max);
            let size = move |range: f64| if range > 1e-9 * largest { range } else { largest };
            let first = kind * numbers / 2;
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
