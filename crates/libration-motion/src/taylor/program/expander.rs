//! The Taylor series of a system about a state, in several lanes.

use std::sync::Arc;

use libration_jit::Compiled;

use super::machine_code::MachineCode;
use super::plan::Plan;
use crate::taylor::System;
use crate::taylor::events::boundary::{Boundary, Forbidden, boundaries};
use crate::taylor::events::steep::{Steep, steep_places};
use crate::taylor::program::Program;
use crate::taylor::step::block::{Block, Row};
use libration_kernels::dispatch::{Kernel, dispatch_lanes};
use libration_numbers::internals::expression::{Evaluator, Operation, Tape};
use libration_numbers::{algebra::Ring, internals::algebra::prepared_reciprocal};

/// The inputs of the tape other than the state.
#[derive(Clone, Debug)]
pub struct Surroundings<const N: usize> {
    /// The values of the open parameters.
    pub parameters: Vec<[f64; N]>,
    /// The sign of the argument of each |…|.
    pub signs: Vec<[f64; N]>,
    /// `true` if the argument of a |…| is a velocity that friction keeps at zero.
    pub sticks: Vec<[bool; N]>,
}

/// Computes series about one state after another, in the same memory.
#[derive(Debug)]
pub struct Expander<'a> {
    pub(in crate::taylor) system: &'a System,
    pub plan: Arc<Plan>,
}

impl<'a> Expander<'a> {
    pub fn new(system: &'a System, order: usize, lanes: usize) -> Self {
        Self { system, plan: system.plans().find(order, lanes, || plan(system, order, lanes)) }
    }

    /// The memory that the series need.
    pub fn block<const N: usize>(&self) -> Block<N> {
        let mut block = Block::new(self.plan.program.rows, self.system.shared_layout(), self.plan.order);
        for &(row, value) in &self.plan.program.constants {
            block[row][0] = [value; N];
        }
        block
    }

    /// Computes the coefficients up to the order, of the coordinates and then of the velocities, whose first coefficients are given.
    pub fn expand<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        if surroundings.sticks.iter().flatten().any(|sticks| *sticks) {
            return self.expand_sticking(block, surroundings);
        }
        self.expand_by(block, surroundings, self.compiled());
    }

    /// Computes the same coefficients, with or without machine code.
    pub fn expand_by<const N: usize>(
        &self,
        block: &mut Block<N>,
        surroundings: &Surroundings<N>,
        compiled: Option<&Compiled>,
    ) {
        dispatch_lanes::<N, _>(Beginning { expander: self, block, surroundings, begun: false });
        self.go_on(block, compiled);
    }

    /// Computes the same coefficients, given the zeroth coefficients of all formulas.
    pub(in crate::taylor) fn expand_begun<const N: usize>(
        &self,
        block: &mut Block<N>,
        surroundings: &Surroundings<N>,
    ) {
        dispatch_lanes::<N, _>(Beginning { expander: self, block, surroundings, begun: true });
        self.go_on(block, self.compiled());
    }

    fn compiled(&self) -> Option<&Compiled> {
        self.plan.expansion.compiled(|| self.straight_line())
    }

    /// Computes all coefficients but the zeroth.
    fn go_on<const N: usize>(&self, block: &mut Block<N>, compiled: Option<&Compiled>) {
        match compiled {
            Some(compiled) => {
                block.run(compiled);
            }
            None => dispatch_lanes::<N, _>(Expansion { expander: self, block }),
        }
    }

    /// The sign of the argument of a |…|.
    pub(in crate::taylor) fn sign<const N: usize>(&self, block: &Block<N>, modulus: usize) -> Row {
        block.row(block.numbers() + 1 + self.system.parameters().len() + modulus)
    }

    /// The argument of an absolute value.
    pub(in crate::taylor) fn argument(&self, modulus: usize) -> Row {
        self.plan.program.results[self.system.coordinates() + modulus]
    }

    /// The formula of an event.
    pub(in crate::taylor) fn event(&self, event: usize) -> Row {
        self.plan.program.results[self.system.event(event)]
    }

    /// The accelerations in a state, the same in all lanes but for the other inputs.
    pub(in crate::taylor) fn accelerations<'s, const N: usize>(
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

    /// Computes the zeroth coefficients.
    #[inline(always)]
    pub(in crate::taylor) fn begin<const N: usize>(
        &self,
        block: &mut Block<N>,
        surroundings: &Surroundings<N>,
    ) {
        self.begin_inputs(block, surroundings);
        self.begin_formulas(block);
    }

    #[inline(always)]
    fn begin_formulas<const N: usize>(&self, block: &mut Block<N>) {
        let arithmetic = self.plan.beginning.compiled(|| self.beginning());
        self.plan.program.begin(block, arithmetic);
    }

    /// The zeroth coefficients of the inputs other than the state.
    #[inline(always)]
    fn begin_inputs<const N: usize>(&self, block: &mut Block<N>, surroundings: &Surroundings<N>) {
        let time = block.row(block.numbers());
        block[time][0] = block.start;
        block[time][1] = block.unit;
        let first = block.numbers() + 1;
        for (number, value) in (first..).zip(&surroundings.parameters) {
            let row = block.row(number);
            block[row][0] = *value;
        }
        // While a velocity sticks, the series of its sign is not constant.
        for (number, sign) in (first + surroundings.parameters.len()..).zip(&surroundings.signs) {
            let row = block.row(number);
            block[row].fill([0.0; N]);
            block[row][0] = *sign;
        }
    }
}

fn plan(system: &System, order: usize, lanes: usize) -> Plan {
    const ENDLESS: usize = usize::MAX;
    let state = std::iter::repeat_n(ENDLESS, system.layout().numbers());
    let parameters = std::iter::repeat_n(0, system.parameters().len());
    let signs = (0..system.moduli()).map(|modulus| match system.driven_in_modulus(modulus) {
        Some(_) => ENDLESS,
        None => 0,
    });
    let degrees: Vec<usize> = state.chain([1]).chain(parameters).chain(signs).collect();
    let last: Vec<bool> =
        (0..system.layout().numbers()).map(|number| system.layout().driving(number).is_some()).collect();
    let program = Program::new(system.tape(), &degrees, &last, order + 1);
    let formulas = system.coordinates() + system.moduli();
    let first_sign = degrees.len() - system.moduli();
    let boundaries = boundaries(system.tape(), formulas, first_sign).into_iter();
    let on_block = |boundary: Boundary<usize>| Boundary {
        of: program.places[boundary.of],
        forbidden: boundary.forbidden,
    };
    let boundaries: Vec<Boundary<Row>> = boundaries.map(on_block).collect();
    let divisors = boundaries.iter().filter(|boundary| boundary.forbidden == Forbidden::Zero);
    let divisors = divisors.map(|boundary| Steep::divisor(boundary.of));
    let steep = steep_places(system.tape(), system.coordinates(), order).into_iter();
    let steep = steep.map(|steep| steep.moved(program.places[steep.of])).chain(divisors).collect();
    let machine_code = || MachineCode::new(lanes, system.is_for_many_steps());
    let (beginning, expansion) = (machine_code(), machine_code());
    let arguments = &system.tape().results()[system.coordinates()..formulas];
    let is_curved = |&&slot: &&usize| !is_linear(system.tape(), slot, system.layout().numbers());
    let curved = arguments.iter().filter(is_curved).map(|&slot| program.places[slot]).collect();
    Plan { order, lanes, program, boundaries, steep, curved, beginning, expansion }
}

/// Returns `true` if a formula of a tape is linear in the first inputs, the state, and in the time.
fn is_linear(tape: &Tape, slot: usize, numbers: usize) -> bool {
    let linear = |operand: usize| is_linear(tape, operand, numbers);
    let constant = |operand: usize| match tape.operations()[operand] {
        Operation::Input(number) => number > numbers,
        _ => tape.is_constant(operand),
    };
    match tape.operations()[slot] {
        Operation::Input(_) => true,
        Operation::Negate(a) => linear(a),
        Operation::Add(a, b) | Operation::Subtract(a, b) => linear(a) && linear(b),
        Operation::Multiply(a, b) => constant(a) && linear(b) || constant(b) && linear(a),
        Operation::Divide(a, b) => linear(a) && constant(b),
        _ => tape.is_constant(slot),
    }
}

/// Computes the inputs, and the zeroth coefficients if they are not known; compiled for each instruction set.
struct Beginning<'e, 'a, const N: usize> {
    expander: &'e Expander<'a>,
    block: &'e mut Block<N>,
    surroundings: &'e Surroundings<N>,
    begun: bool,
}

impl<const N: usize> Kernel for Beginning<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { expander, block, surroundings, begun } = self;
        expander.begin_inputs(block, surroundings);
        if !begun {
            expander.begin_formulas(block);
        }
    }
}

/// Computes the coefficients of higher order.
struct Expansion<'e, 'a, const N: usize> {
    expander: &'e Expander<'a>,
    block: &'e mut Block<N>,
}

impl<const N: usize> Kernel for Expansion<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { expander, block } = self;
        for n in 1..=expander.plan.order {
            expander.extend_state(block, n);
            if n <= expander.last() {
                expander.plan.program.extend(block, n);
            }
        }
    }
}

/// The n-th coefficient of a quantity with a given rate of change, whose earlier coefficients are known.
#[inline(always)]
pub(in crate::taylor) fn rate<X, E: Evaluator<Row, X>>(
    on: &E,
    of: Row,
    unit: &<E::Ring as Ring>::Element,
    n: usize,
) -> Option<<E::Ring as Ring>::Element> {
    let (ring, order, before) = (on.ring(), u64::try_from(n).unwrap_or(u64::MAX), &on.row(of)[n - 1]);
    match prepared_reciprocal(order) {
        // The unit is a power of two, so that this is the same product, but without waiting for other results.
        Some(_) => Some(ring.multiply(before, &ring.over_integer(unit, order)?)),
        None => ring.over_integer(&ring.multiply(before, unit), order),
    }
}

impl Expander<'_> {
    /// Every rate of change with the quantity that changes: the velocity for a coordinate, and the acceleration
    /// for the velocity; in equations of first order the right-hand side for the coordinate itself.
    #[inline(always)]
    pub(in crate::taylor) fn rates(&self) -> impl Iterator<Item = (Row, Row)> {
        let (layout, terms) = (self.system.layout(), self.plan.order + 1);
        let row = move |number: usize| Row::new(number, terms);
        (0..layout.coordinates()).flat_map(move |i| {
            let velocity = layout.velocity(i).map(|velocity| (row(velocity), row(i)));
            velocity.into_iter().chain([(self.acceleration(i), row(layout.driven(i)))])
        })
    }

    /// Computes each xₙ from vₙ₋₁ and each vₙ from aₙ₋₁, where each aₙ depends only on coefficients up to xₙ and vₙ.
    #[inline(always)]
    pub(in crate::taylor) fn extend_state<const N: usize>(&self, block: &mut Block<N>, n: usize) {
        for (of, out) in self.rates() {
            if let Some(value) = rate(block, of, &block.unit, n) {
                block[out][n] = value;
            }
        }
    }

    /// The highest order that is requested of formulas: events require the same order as the state.
    #[inline(always)]
    pub(in crate::taylor) fn last(&self) -> usize {
        self.plan.order - usize::from(self.system.events().is_empty())
    }

    /// The right-hand side of a coordinate's equation: its acceleration, or its rate of change.
    #[inline(always)]
    pub(in crate::taylor) fn acceleration(&self, coordinate: usize) -> Row {
        self.plan.program.results[coordinate]
    }
}
