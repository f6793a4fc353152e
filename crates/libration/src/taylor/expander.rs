//! The Taylor series of a system about a state, in several lanes.

use super::System;
use super::block::{Block, Row};
use super::boundary::{Boundary, Forbidden, boundaries};
use super::program::{Program, over_integer};
use super::steep::{Steep, steep_places};
use crate::algebra::lanes;
use crate::dispatch::{Kernel, dispatch};

/// What the tape is given beside the state.
#[derive(Clone, Debug)]
pub(super) struct Surroundings<const N: usize> {
    /// The values of the parameters that were left open.
    pub(super) parameters: Vec<[f64; N]>,
    /// The sign of what stands in each |…|.
    pub(super) signs: Vec<[f64; N]>,
    /// Whether that is a velocity that friction keeps at zero.
    pub(super) sticks: Vec<[bool; N]>,
}

/// Makes series about one state after the other, always in the same memory.
#[derive(Debug)]
pub(super) struct Expander<'a> {
    pub(super) system: &'a System,
    pub(super) program: Program,
    /// Where the accelerations end, and what stands in |…|.
    pub(super) boundaries: Vec<Boundary<Row>>,
    /// Of what the accelerations are steep functions.
    pub(super) steep: Vec<Steep<Row>>,
    pub(super) order: usize,
}

impl<'a> Expander<'a> {
    pub(super) fn new(system: &'a System, order: usize) -> Self {
        const ENDLESS: usize = usize::MAX;
        let state = std::iter::repeat_n(ENDLESS, system.layout().numbers());
        let parameters = std::iter::repeat_n(0, system.parameters().len());
        let signs = (0..system.moduli()).map(|modulus| match system.driven_in_modulus(modulus) {
            Some(_) => ENDLESS,
            None => 0,
        });
        let degrees: Vec<usize> = state.chain([1]).chain(parameters).chain(signs).collect();
        let program = Program::new(system.tape(), &degrees, order + 1);
        let formulas = system.coordinates() + system.moduli();
        let first_sign = degrees.len() - system.moduli();
        let boundaries = boundaries(system.tape(), formulas, first_sign).into_iter();
        let on_block = |it: Boundary<usize>| Boundary { of: program.places[it.of], forbidden: it.forbidden };
        let boundaries: Vec<Boundary<Row>> = boundaries.map(on_block).collect();
        let divisors = boundaries.iter().filter(|boundary| boundary.forbidden == Forbidden::Zero);
        let divisors = divisors.map(|boundary| Steep::divisor(boundary.of));
        let steep = steep_places(system.tape(), system.coordinates(), order).into_iter();
        let steep = steep.map(|it| it.moved(program.places[it.of])).chain(divisors).collect();
        Self { system, boundaries, steep, program, order }
    }

    /// The memory that the series need.
    pub(super) fn block<const N: usize>(&self) -> Block<N> {
        let mut block = Block::new(self.program.rows, self.system.shared_layout(), self.order);
        for &(row, value) in &self.program.constants {
            block[row][0] = [value; N];
        }
        block
    }

    /// Fills in the coefficients up to the order, of the coordinates and then of the velocities, whose first are given.
    pub(super) fn expand<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        if surroundings.sticks.iter().flatten().any(|sticks| *sticks) {
            return self.expand_sticking(block, surroundings);
        }
        dispatch(Expansion { expander: self, block, surroundings, begun: false });
    }

    /// The same where all zeroth coefficients of the formulas are known.
    pub(super) fn expand_begun<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        dispatch(Expansion { expander: self, block, surroundings, begun: true });
    }

    /// The sign of what stands in a |…|.
    pub(super) fn sign<const N: usize>(&self, block: &Block<N>, modulus: usize) -> Row {
        block.row(block.numbers() + 1 + self.system.parameters().len() + modulus)
    }

    /// What stands between the bars of an absolute value.
    pub(super) fn argument(&self, modulus: usize) -> Row {
        self.program.results[self.system.coordinates() + modulus]
    }

    /// The formula of an event.
    pub(super) fn event(&self, event: usize) -> Row {
        self.program.results[self.system.coordinates() + self.system.moduli() + event]
    }

    /// The accelerations in a state, the same in all lanes but for what surrounds them.
    pub(super) fn accelerations<'s, const N: usize>(
        &'s self,
        scratch: &'s mut Block<N>,
        time: f64,
        state: &[f64],
        surroundings: &Surroundings<N>,
    ) -> impl Iterator<Item = [f64; N]> + 's {
        for (number, value) in state.iter().enumerate() {
            let row = scratch.row(number);
            scratch[row][0] = [*value; N];
        }
        scratch.start = [time; N];
        self.begin(scratch, surroundings);
        (0..self.system.coordinates()).map(|i| scratch[self.acceleration(i)][0])
    }

    /// The zeroth coefficients.
    #[inline(always)]
    pub(super) fn begin<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        self.begin_inputs(block, surroundings);
        self.program.begin(block);
    }

    /// Those of what the tape is given beside the state.
    #[inline(always)]
    fn begin_inputs<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        let time = block.row(block.numbers());
        block[time][0] = block.start;
        block[time][1] = block.unit;
        let rest = surroundings.parameters.iter().chain(&surroundings.signs);
        for (number, values) in (block.numbers() + 1..).zip(rest) {
            let row = block.row(number);
            block[row].fill([0.0; N]);
            block[row][0] = *values;
        }
    }
}

/// The expansion, compiled for each instruction set.
struct Expansion<'e, 'a, const N: usize> {
    expander: &'e Expander<'a>,
    block: &'e mut Block<N>,
    surroundings: &'e Surroundings<N>,
    begun: bool,
}

impl<const N: usize> Kernel for Expansion<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { expander, block, surroundings, begun } = self;
        expander.begin_inputs(block, surroundings);
        if !begun {
            expander.program.begin(block);
        }
        for n in 1..=expander.order {
            expander.extend_state(block, n);
            if n <= expander.last() {
                expander.program.extend(block, n);
            }
        }
    }
}

impl Expander<'_> {
    /// x₍ₙ₎ = v₍ₙ₋₁₎/n and v₍ₙ₎ = a₍ₙ₋₁₎/n, where each a₍ₙ₎ needs no more than x₍ₙ₎ and v₍ₙ₎; of the first order x₍ₙ₎ = a₍ₙ₋₁₎/n.
    #[inline(always)]
    pub(super) fn extend_state<const N: usize>(&self, block: &mut Block<N>, n: usize) {
        let layout = self.system.layout();
        for i in 0..layout.coordinates() {
            if let Some(velocity) = layout.velocity(i) {
                let (coordinate, velocity) = (block.row(i), block.row(velocity));
                let speed = &block[velocity][n - 1];
                let rate = lanes(|lane| speed[lane] * block.unit[lane]);
                block[coordinate][n] = over_integer(&rate, n);
            }
            let driven = block.row(layout.driven(i));
            let acceleration = &block[self.acceleration(i)][n - 1];
            let rate = lanes(|lane| acceleration[lane] * block.unit[lane]);
            block[driven][n] = over_integer(&rate, n);
        }
    }

    /// The last order that is asked for of formulas: events want as many as the state has.
    #[inline(always)]
    pub(super) fn last(&self) -> usize {
        self.order - usize::from(self.system.events().is_empty())
    }

    /// What the equation of a coordinate tells: its acceleration, or its rate of change.
    #[inline(always)]
    pub(super) fn acceleration(&self, coordinate: usize) -> Row {
        self.program.results[coordinate]
    }
}
