//! All series of one step in several lanes, in one block of memory.

use std::ops::{Index, IndexMut};
use std::sync::Arc;

use libration_jit::{Aligned, Compiled};

use super::ends::Ends;
use crate::taylor::step::{elapsed, grown, higher};
use crate::taylor::{StateLayout, Step};
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::internals::algebra::any;

/// One series of a block, given by the index of its first coefficient in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::taylor) struct Row(usize);

impl Row {
    /// The row with this number, if each row has `terms` coefficients.
    #[inline(always)]
    pub(in crate::taylor) fn new(number: usize, terms: usize) -> Self {
        Self(number * terms)
    }

    /// The index of the first coefficient of the row.
    pub(in crate::taylor) fn first(self) -> usize {
        self.0
    }
}

/// The series of one step in N lanes: of all coordinates, then of all velocities, then of the quantities from which they are computed.
#[derive(Debug)]
pub struct Block<const N: usize> {
    pub(in crate::taylor) start: [f64; N],
    pub end: [f64; N],
    /// The unit of time of the series, a power of two: with it coefficients neither overflow nor underflow, whatever the units of the equations.
    pub unit: [f64; N],
    /// Coefficients in powers of the time since the start, row by row, in aligned memory.
    pub coefficients: Aligned,
    /// Scratch memory for machine code.
    scratch: Aligned,
    /// The low words of the state, which are not part of the first coefficients.
    low: Vec<[f64; N]>,
    layout: Arc<StateLayout>,
    /// Number of coefficients in each row.
    terms: usize,
}

/// The lengths of steps in units of their time, and the remainders in the unit of the equations.
#[derive(Clone, Copy, Debug)]
pub struct Lengths<const N: usize> {
    pub(in crate::taylor) units: [f64; N],
    remainders: [f64; N],
}

impl<const N: usize> Index<Row> for Block<N> {
    type Output = [[f64; N]];

    #[inline(always)]
    fn index(&self, Row(row): Row) -> &[[f64; N]] {
        &self.coefficients.numbers().as_chunks().0[row..row + self.terms]
    }
}

impl<const N: usize> IndexMut<Row> for Block<N> {
    #[inline(always)]
    fn index_mut(&mut self, Row(row): Row) -> &mut [[f64; N]] {
        &mut self.coefficients.numbers_mut().as_chunks_mut().0[row..row + self.terms]
    }
}

impl<const N: usize> Block<N> {
    /// A block of `rows` rows, the first of which are the state components.
    pub(in crate::taylor) fn new(rows: usize, layout: &Arc<StateLayout>, order: usize) -> Self {
        let terms = order + 1;
        let coefficients = Aligned::zeros(rows * terms * N);
        let low = vec![[0.0; N]; layout.numbers()];
        let layout = Arc::clone(layout);
        let scratch = Aligned::default();
        Self { start: [0.0; N], end: [0.0; N], unit: [1.0; N], coefficients, scratch, low, layout, terms }
    }

    /// Runs machine code on all coefficients.
    pub(in crate::taylor) fn run(&mut self, compiled: &Compiled) {
        compiled.run(self.coefficients.numbers_mut(), &self.unit, &mut self.scratch);
    }

    /// The number of state components.
    #[inline(always)]
    pub(in crate::taylor) fn numbers(&self) -> usize {
        self.low.len()
    }

    /// The meaning of each state component.
    #[inline(always)]
    pub(in crate::taylor) fn layout(&self) -> &StateLayout {
        &self.layout
    }

    /// The zeroth coefficient of a row.
    #[inline(always)]
    pub(in crate::taylor) fn zeroth(&self, Row(row): Row) -> &[f64; N] {
        &self.coefficients.numbers().as_chunks().0[row]
    }

    #[inline(always)]
    pub(in crate::taylor) fn zeroth_mut(&mut self, Row(row): Row) -> &mut [f64; N] {
        &mut self.coefficients.numbers_mut().as_chunks_mut().0[row]
    }

    /// The row with this number; the state components come first.
    #[inline(always)]
    pub(in crate::taylor) fn row(&self, number: usize) -> Row {
        Row::new(number, self.terms)
    }

    /// The series of one state component.
    #[inline(always)]
    pub fn series(&self, number: usize) -> &[[f64; N]] {
        &self[self.row(number)]
    }

    /// The series of the state components and of all parts of the formulas.
    pub(in crate::taylor) fn rows(&self) -> impl Iterator<Item = &[[f64; N]]> {
        self.coefficients.numbers().as_chunks().0.chunks_exact(self.terms)
    }

    /// The last coefficients of all state components.
    #[inline(always)]
    pub(in crate::taylor) fn last_coefficients(&self) -> impl Iterator<Item = &[f64; N]> {
        (0..self.numbers()).filter_map(|number| self.series(number).last())
    }

    /// Sets a lane to a time and a state.
    pub fn start(&mut self, lane: usize, time: f64, state: &[f64]) {
        (self.start[lane], self.end[lane], self.unit[lane]) = (time, time, 1.0);
        for (number, &value) in state.iter().enumerate() {
            self.set_component(number, lane, value, 0.0);
        }
    }

    /// Sets a state component to a value in two words.
    pub(in crate::taylor) fn set_component(&mut self, number: usize, lane: usize, high: f64, low: f64) {
        let row = self.row(number);
        self[row][0][lane] = high;
        self.low[number][lane] = low;
    }

    /// Sets a state component to zero.
    pub(in crate::taylor) fn stop(&mut self, number: usize, lane: usize) {
        self.set_component(number, lane, 0.0, 0.0);
    }

    /// The lengths of the steps.
    #[inline(always)]
    pub fn lengths(&self) -> Lengths<N> {
        let [mut units, mut remainders] = [[0.0; N]; 2];
        for lane in 0..N {
            (units[lane], remainders[lane]) = elapsed(self.start[lane], self.end[lane]);
            units[lane] /= self.unit[lane];
        }
        Lengths { units, remainders }
    }

    /// One component of the state at the ends of steps of the given lengths.
    #[inline(always)]
    pub fn ends(&self, number: usize, Lengths { units, remainders }: &Lengths<N>) -> Ends<N> {
        let series = self.series(number);
        let slope_low = self.layout.velocity(number).map_or([0.0; N], |velocity| self.low[velocity]);
        let higher = higher(self.terms, |n| series[n], units);
        let mut ends = Ends { high: [0.0; N], low: [0.0; N] };
        for lane in 0..N {
            let base = DoubleDouble::new(series[0][lane], self.low[number][lane]);
            let end =
                grown(base, series[1][lane], slope_low[lane] * self.unit[lane], higher[lane], units[lane]);
            (ends.high[lane], ends.low[lane]) = (end.hi, end.lo);
        }
        if any(remainders, |remainder| remainder != 0.0) {
            for lane in (0..N).filter(|&lane| remainders[lane] != 0.0) {
                let end = self.step(lane).component_at(number, self.end[lane]);
                (ends.high[lane], ends.low[lane]) = (end.hi, end.lo);
            }
        }
        ends
    }

    /// Sets the starts of the next steps to the ends of these, with the states there and these units.
    pub fn begin_at_end(&mut self, states: &[Ends<N>], unit: &[f64; N]) {
        for (number, ends) in states.iter().enumerate() {
            let row = self.row(number);
            self[row][0] = ends.high;
            self.low[number] = ends.low;
        }
        (self.start, self.unit) = (self.end, *unit);
    }

    /// The state of the motion at the start of the step.
    pub(in crate::taylor) fn state(&self, lane: usize) -> impl Iterator<Item = f64> {
        (0..self.numbers()).map(move |number| self.series(number)[0][lane] + self.low[number][lane])
    }

    /// The step of one lane.
    pub fn step(&self, lane: usize) -> Step<'_> {
        Step {
            start: self.start[lane],
            end: self.end[lane],
            unit: self.unit[lane],
            coefficients: self.coefficients.numbers(),
            low: self.low.as_flattened(),
            layout: &self.layout,
            terms: self.terms,
            lanes: N,
            lane,
        }
    }
}
