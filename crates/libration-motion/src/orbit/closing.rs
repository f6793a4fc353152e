//! One round of an orbit from a state, and the dependence of its end on its start.

use super::error::OrbitError;
use super::near::OrbitGuess;
use super::path::{Path, maximum_in, until};
use crate::periodic::{Flow, Variations};
use crate::taylor::{IntegrationError, Moment, StateLayout};
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use std::f64::consts::TAU;

/// The flow of a system without parameters, round by round.
#[derive(Debug)]
pub(super) struct Rounds<'w> {
    flow: Flow,
    watch: &'w Watch<'w>,
}

/// One round with its derivatives.
#[derive(Debug)]
pub(super) struct Round {
    pub(super) path: Path,
    /// End minus start.
    pub(super) defect: Vec<f64>,
    /// Derivatives of the end with respect to the start, by rows.
    pub(super) monodromy: Vec<Vec<f64>>,
    /// Derivatives of the end with respect to the duration.
    pub(super) rate: Vec<f64>,
}

/// Smallest scale of a component relative to its distance from zero; a component that moves by less is measured by this scale.
const LEAST_SIZE: f64 = 1e-5;
/// Maximum number of steps of one round; van der Pol's oscillator with the strength 1000 takes 3e5.
const MOST_STEPS: usize = 1_000_000;
/// The tolerance for integrating variations, and another one with different errors.
const VARIATIONS: [f64; 2] = [1e-15, 1e-14];

impl<'w> Rounds<'w> {
    pub(super) fn new(equation: &Equation, watch: &'w Watch<'w>) -> Result<Self, OrbitError> {
        Ok(Self { flow: Flow::new(equation, &[], MOST_STEPS)?, watch })
    }

    pub(super) fn layout(&self) -> &StateLayout {
        &self.flow.layout
    }

    /// The motion without derivatives.
    pub(super) fn path(
        &self,
        state: &[f64],
        duration: f64,
        tolerance: f64,
    ) -> Result<Path, IntegrationError> {
        let start = Moment { time: 0.0, state: state.to_vec() };
        Path::to_time(self.flow.system(), &start, duration, &self.flow.effort(tolerance), self.watch)
    }

    /// The motion from a maximum of a second-order coordinate to the next one, expected after about the period of the guess.
    pub(super) fn turn(
        &self,
        coordinate: usize,
        start: &OrbitGuess,
        tolerance: f64,
    ) -> Result<Option<Path>, IntegrationError> {
        let horizons = [1.5 * start.period, 2.0 * start.period];
        let start = Moment { time: 0.0, state: start.state.clone() };
        let effort = self.flow.effort(tolerance);
        until(self.flow.system(), &start, horizons, &effort, self.watch, |step| maximum_in(step, coordinate))
    }

    /// The motion with its derivatives.
    pub(super) fn round(&self, state: &[f64], duration: f64) -> Result<Round, OrbitError> {
        let path = self.path(state, duration, 1e-17)?;
        let end = path.state_at(duration);
        let Variations { by_start: monodromy, rates: [_, rate], .. } =
            self.variations(state, [0.0, duration])?;
        if rate.iter().any(|component| component.is_nan()) {
            return Err(OrbitError::Start { state: end, wanted: self.layout().numbers() });
        }
        let defect = end.iter().zip(state).map(|(end, start)| end - start).collect();
        Ok(Round { path, defect, monodromy, rate })
    }

    /// The index of the component that is held fixed when a cycle is closed that begins at a maximum of a coordinate: the velocity of
    /// that coordinate or, without one, the component that changes fastest there, since the coordinate itself is stationary.
    pub(super) fn held_at_maximum(&self, coordinate: usize, guess: &OrbitGuess) -> Result<usize, OrbitError> {
        if let Some(velocity) = self.layout().velocity(coordinate) {
            return Ok(velocity);
        }
        let round = self.round(&guess.state, guess.period)?;
        let rate = self.rate(&guess.state, 0.0)?;
        let paces: Vec<f64> = rate
            .iter()
            .zip(round.sizes(self.layout(), guess))
            .map(|(rate, size)| (rate / size).abs())
            .collect();
        let fastest = (0..paces.len()).max_by(|a, b| paces[*a].total_cmp(&paces[*b]));
        Ok(fastest.unwrap_or(0))
    }

    /// The state after a time with its derivatives.
    pub(super) fn variations(&self, state: &[f64], times: [f64; 2]) -> Result<Variations, IntegrationError> {
        self.flow.variations(state, &[], times, VARIATIONS[0], || self.watch.flow())
    }

    /// Returns `true` if a force jumps.
    pub(super) const fn has_jumps(&self) -> bool {
        self.flow.has_jumps()
    }

    /// The derivatives with respect to the start with another tolerance, and the largest magnitude of each derivative on the way.
    pub(super) fn largest_variations(
        &self,
        state: &[f64],
        duration: f64,
    ) -> Result<[Vec<Vec<f64>>; 2], IntegrationError> {
        let (end, largest) =
            self.flow.largest_variations(state, &[], [0.0, duration], VARIATIONS[1], || self.watch.flow())?;
        Ok([end.by_start, largest])
    }

    /// The time derivative of the state.
    pub(super) fn rate(&self, state: &[f64], time: f64) -> Result<Vec<f64>, OrbitError> {
        let refusal = || OrbitError::Start { state: state.to_vec(), wanted: self.layout().numbers() };
        self.flow.rate(state, time, &[]).ok_or_else(refusal)
    }
}

impl Round {
    /// The range of each state component on the orbit, the scale of its errors: at least [`LEAST_SIZE`]
    /// of the coordinate, and the range of the other components of its kind if it hardly moves at all.
    pub(super) fn sizes(&self, layout: &StateLayout, start: &OrbitGuess) -> Vec<f64> {
        let pace = TAU / start.period;
        let least = |number: usize| {
            let coordinate = layout.driving(number).unwrap_or(number);
            let size = LEAST_SIZE * start.state[coordinate].abs();
            if layout.is_velocity(number) { size * pace } else { size }
        };
        let ranges = self.ranges(layout.numbers());
        let (displacements, velocities) = ranges.split_at(layout.coordinates());
        let kinds = [(0, displacements), (layout.coordinates(), velocities)].into_iter();
        let sizes = kinds.flat_map(|(first, ranges)| {
            let largest = ranges.iter().copied().fold(0.0, f64::max);
            // A coordinate that hardly moves, or by rounding alone, has no size of its own.
            let size = move |range: f64| if range > 1e-9 * largest { range } else { largest };
            ranges.iter().enumerate().map(move |(i, range)| size(*range).max(least(first + i)))
        });
        sizes.map(|size| if size > 0.0 { size } else { 1.0 }).collect()
    }

    /// The range of each state component. Its values at the ends of steps are not enough: where steps end at jumps of a force these may all be equal.
    fn ranges(&self, numbers: usize) -> Vec<f64> {
        let range = |component: usize| {
            let [low, high] = self.path.extrema(component);
            (high - low).max(0.0)
        };
        (0..numbers).map(range).collect()
    }
}
