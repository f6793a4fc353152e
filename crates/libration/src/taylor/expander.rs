//! The Taylor series of a system about a state, in several lanes.

use super::System;
use super::block::Block;
use crate::algebra::{Lanes, Ring};
use crate::dispatch::{Kernel, dispatch};
use crate::expression::Jet;

/// What the tape is given beside the state.
#[derive(Clone, Debug)]
pub(super) struct Surroundings<const N: usize> {
    /// The values of the parameters that were left open.
    pub(super) parameters: Vec<[f64; N]>,
    /// The sign of what stands in each |…|.
    pub(super) signs: Vec<[f64; N]>,
}

/// Makes series about one state after the other, always in the same memory.
#[derive(Debug)]
pub(super) struct Expander<'a, const N: usize> {
    system: &'a System,
    order: usize,
    jet: Jet<'a, Lanes<N>>,
    /// One coefficient of each input.
    inputs: Vec<[f64; N]>,
}

/// Why all values of formulas exist.
const ALL_VALUES: &str = "where a float has no value it is NaN";

impl<'a, const N: usize> Expander<'a, N> {
    pub(super) fn new(system: &'a System, order: usize) -> Self {
        let inputs = vec![[0.0; N]; system.tape().inputs()];
        let mut jet = Jet::new(&Lanes, system.tape(), &inputs).expect(ALL_VALUES);
        jet.reserve(order + 1);
        Self { system, order, jet, inputs }
    }

    pub(super) fn system(&self) -> &'a System {
        self.system
    }

    /// Fills in the coefficients up to the order, of the coordinates and then of the velocities, whose first are given.
    pub(super) fn expand(&mut self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        dispatch(Expansion { expander: self, block, surroundings });
    }

    /// What stands between the bars of an absolute value.
    pub(super) fn argument(&self, modulus: usize) -> &[[f64; N]] {
        self.jet.result(self.system.coordinates() + modulus)
    }

    /// The formula of an event.
    pub(super) fn event(&self, event: usize) -> &[[f64; N]] {
        self.jet.result(self.system.coordinates() + self.system.moduli() + event)
    }

    /// The accelerations in a state of all lanes.
    pub(super) fn accelerations(
        &mut self,
        time: f64,
        state: &[f64],
        surroundings: &Surroundings<N>,
    ) -> Vec<[f64; N]> {
        for (input, value) in self.inputs.iter_mut().zip(state.iter().chain([&time])) {
            *input = [*value; N];
        }
        self.begin(surroundings);
        (0..self.system.coordinates()).map(|i| *self.jet.last(i)).collect()
    }

    /// Begins a jet with the inputs of states and time, and those that follow.
    #[inline(always)]
    fn begin(&mut self, surroundings: &Surroundings<N>) {
        let rest = &mut self.inputs[2 * self.system.coordinates() + 1..];
        let (parameters, signs) = rest.split_at_mut(surroundings.parameters.len());
        parameters.copy_from_slice(&surroundings.parameters);
        signs.copy_from_slice(&surroundings.signs);
        self.jet.restart(&self.inputs).expect(ALL_VALUES);
        self.inputs[2 * self.system.coordinates() + 1..].fill([0.0; N]);
    }

    /// The n-th coefficients of all states and of the time as inputs.
    #[inline(always)]
    fn feed(&mut self, block: &Block<N>, n: usize) {
        let numbers = block.numbers();
        for number in 0..numbers {
            self.inputs[number] = block.series(number)[n];
        }
        self.inputs[numbers] = if n == 0 { block.start } else { [if n == 1 { 1.0 } else { 0.0 }; N] };
    }
}

/// The expansion, compiled for each instruction set.
struct Expansion<'e, 'a, const N: usize> {
    expander: &'e mut Expander<'a, N>,
    block: &'e mut Block<N>,
    surroundings: &'e Surroundings<N>,
}

impl<const N: usize> Kernel for Expansion<'_, '_, N> {
    type Output = ();

    /// x₍ₙ₎ = v₍ₙ₋₁₎/n and v₍ₙ₎ = a₍ₙ₋₁₎/n, where each a₍ₙ₎ needs no more than x₍ₙ₎ and v₍ₙ₎.
    #[inline(always)]
    fn run(self) {
        let Self { expander, block, surroundings } = self;
        let coordinates = expander.system.coordinates();
        expander.feed(block, 0);
        expander.begin(surroundings);
        let last = expander.order - usize::from(expander.system.events().is_empty());
        for (n, divisor) in (1..=expander.order).zip(1..) {
            let over_n = |c: &[f64; N]| Lanes.over_integer(c, divisor).expect(ALL_VALUES);
            for i in 0..coordinates {
                let velocity = block.series(coordinates + i)[n - 1];
                block.series_mut(i)[n] = over_n(&velocity);
                block.series_mut(coordinates + i)[n] = over_n(expander.jet.last(i));
            }
            if n <= last {
                expander.feed(block, n);
                expander.jet.extend(&expander.inputs).expect(ALL_VALUES);
            }
        }
    }
}
