//! The series of a state in several lanes, in one block of memory.

use super::Step;
use super::flight::Ends;
use super::step::{elapsed, grown};
use crate::double_double::DoubleDouble;

/// The polynomials of one step in N lanes: of all coordinates, then of all velocities.
#[derive(Debug)]
pub(super) struct Block<const N: usize> {
    pub(super) start: [f64; N],
    pub(super) end: [f64; N],
    /// Coefficients in powers of the time since the start, those of one number of the state behind each other.
    coefficients: Vec<[f64; N]>,
    /// What the first coefficients lack of the state.
    low: Vec<[f64; N]>,
    /// How many coefficients each number has.
    terms: usize,
}

impl<const N: usize> Block<N> {
    pub(super) fn new(numbers: usize, order: usize) -> Self {
        let terms = order + 1;
        let coefficients = vec![[0.0; N]; numbers * terms];
        Self { start: [0.0; N], end: [0.0; N], coefficients, low: vec![[0.0; N]; numbers], terms }
    }

    /// How many numbers a state has.
    #[inline(always)]
    pub(super) fn numbers(&self) -> usize {
        self.low.len()
    }

    #[inline(always)]
    pub(super) fn series(&self, number: usize) -> &[[f64; N]] {
        &self.coefficients[number * self.terms..][..self.terms]
    }

    #[inline(always)]
    pub(super) fn series_mut(&mut self, number: usize) -> &mut [[f64; N]] {
        &mut self.coefficients[number * self.terms..][..self.terms]
    }

    /// Brings a lane to a time and a state.
    pub(super) fn launch(&mut self, lane: usize, time: f64, state: &[f64]) {
        (self.start[lane], self.end[lane]) = (time, time);
        for (number, &value) in state.iter().enumerate() {
            self.series_mut(number)[0][lane] = value;
            self.low[number][lane] = 0.0;
        }
    }

    /// One number of the state at the ends of the steps.
    #[inline(always)]
    pub(super) fn ends(&self, number: usize) -> Ends<N> {
        let series = self.series(number);
        let velocity_low = self.low.get(number + self.numbers() / 2).map_or([0.0; N], |low| *low);
        let mut times = [(0.0, 0.0); N];
        for lane in 0..N {
            times[lane] = elapsed(self.start[lane], self.end[lane]);
        }
        let mut higher = [0.0; N];
        for c in series[2..].iter().rev() {
            for lane in 0..N {
                higher[lane] = (higher[lane] + c[lane]) * times[lane].0;
            }
        }
        let mut ends = Ends { high: [0.0; N], low: [0.0; N] };
        for lane in 0..N {
            let base = DoubleDouble::new(series[0][lane], self.low[number][lane]);
            let end = grown(base, series[1][lane], velocity_low[lane], higher[lane], times[lane].0);
            (ends.high[lane], ends.low[lane]) = (end.hi, end.lo);
        }
        for lane in (0..N).filter(|&lane| times[lane].1 != 0.0) {
            let end = self.step(lane).component_at(number, self.end[lane]);
            (ends.high[lane], ends.low[lane]) = (end.hi, end.lo);
        }
        ends
    }

    /// Begins the next steps where these end, in the states there.
    pub(super) fn begin_at_end(&mut self, states: &[Ends<N>]) {
        for (number, ends) in states.iter().enumerate() {
            self.series_mut(number)[0] = ends.high;
            self.low[number] = ends.low;
        }
        self.start = self.end;
    }

    /// Where a motion is.
    pub(super) fn state(&self, lane: usize) -> impl Iterator<Item = f64> {
        (0..self.numbers()).map(move |number| self.series(number)[0][lane] + self.low[number][lane])
    }

    /// The step of one lane.
    pub(super) fn step(&self, lane: usize) -> Step<'_> {
        Step {
            start: self.start[lane],
            end: self.end[lane],
            coefficients: self.coefficients.as_flattened(),
            low: self.low.as_flattened(),
            terms: self.terms,
            lanes: N,
            lane,
        }
    }
}
