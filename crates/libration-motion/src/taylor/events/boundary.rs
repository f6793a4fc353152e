//! Boundaries of formulas: zeros of divisors, of the arguments of roots and logarithms, poles of the tangent.
//!
//! Most of these are singularities of the motion, before which steps become short by themselves. But the first
//! terms of the series of a force that is flat there, such as e^(−1/x), or nearly flat, such as √(x² + ε²), do
//! not show the boundary: a step would pass it, into a region in which the series does not represent the formula.
//!
//! # Method
//! The zeros of divisors, bases of roots and arguments of logarithms, and the poles of tangents, are searched on the
//! polynomial of the step. After a zero the accelerations are compared with the series. If they differ the step ends
//! before the zero and the next one ends closer to it, until steps are too short or the series resolve the boundary.

use std::f64::consts::{FRAC_PI_2, PI};

use super::contacts::Stretch;
use crate::taylor::step::block::{Block, Row};
use crate::taylor::step::largest_change::largest_changes;
use crate::taylor::step::sign_change::scaled;
use libration_numbers::algebra::Function;
use libration_numbers::internals::expression::{Operation, Tape};

/// The values that a slot of the tape must not take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::taylor) enum Forbidden {
    Zero,
    /// π/2 and all values that differ from it by multiples of π.
    OddQuarterTurns,
}

/// A value on the tape, given by its slot, that must not take certain values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::taylor) struct Boundary<P> {
    pub(in crate::taylor) of: P,
    pub(in crate::taylor) forbidden: Forbidden,
}

/// The boundaries of the first `formulas` formulas on a tape. The signs of |…| are the inputs from
/// `first_sign` on; steps end at the zeros of a |…| anyway, where the sign is multiplied by the argument.
pub(in crate::taylor) fn boundaries(tape: &Tape, formulas: usize, first_sign: usize) -> Vec<Boundary<usize>> {
    let mut boundaries = vec![];
    let mut add = |of: usize, forbidden: Forbidden| {
        let boundary = Boundary { of, forbidden };
        if !tape.is_constant(of) && !boundaries.contains(&boundary) {
            boundaries.push(boundary);
        }
    };
    for slot in reached(tape, formulas) {
        let divisor = match tape.operations()[slot] {
            Operation::Divide(_, divisor) => divisor,
            // Powers with natural exponents are products.
            Operation::Power(base, _) => base,
            Operation::Inverse { function, divisor, .. } if function.domain().is_some() => divisor,
            Operation::Tangent { function: Function::Tan, of } => {
                add(of, Forbidden::OddQuarterTurns);
                continue;
            }
            _ => continue,
        };
        for zero in zeros(tape, divisor, first_sign) {
            add(zero, Forbidden::Zero);
        }
    }
    boundaries
}

/// The slots on which the first `formulas` formulas depend.
pub(in crate::taylor) fn reached(tape: &Tape, formulas: usize) -> Vec<usize> {
    let mut reached = vec![false; tape.operations().len()];
    for &result in &tape.results()[..formulas] {
        reached[result] = true;
    }
    // The operands of an instruction have smaller slots than the instruction.
    for slot in (0..reached.len()).rev() {
        if reached[slot] {
            tape.operands(slot).into_iter().for_each(|operand| reached[operand] = true);
        }
    }
    (0..reached.len()).filter(|&slot| reached[slot]).collect()
}

/// The slots that are zero where this one is, as simple zeros as far as the formula shows.
fn zeros(tape: &Tape, slot: usize, first_sign: usize) -> Vec<usize> {
    let is_sign =
        |operand: usize| matches!(tape.operations()[operand], Operation::Input(n) if n >= first_sign);
    match tape.operations()[slot] {
        Operation::Multiply(a, b) if is_sign(a) || is_sign(b) => vec![],
        Operation::Multiply(a, b) => [zeros(tape, a, first_sign), zeros(tape, b, first_sign)].concat(),
        // The zero of a divisor or of the base of a power is a separate boundary.
        Operation::Negate(a) | Operation::Divide(a, _) | Operation::Power(a, _) => zeros(tape, a, first_sign),
        Operation::Exp(_) => vec![],
        Operation::Paired { function, .. } if !function.has_zeros() => vec![],
        _ => vec![slot],
    }
}

impl Boundary<Row> {
    /// Returns `true` if in steps of these lengths, in units of the block, the values are known to stay far from the forbidden ones: the
    /// distance exceeds their change, and the largest blur, a hundredth of all their terms.
    #[inline(always)]
    pub(in crate::taylor) fn is_far<const N: usize>(&self, block: &Block<N>, lengths: &[f64; N]) -> bool {
        const WITH_BLUR: f64 = 1.05;
        if self.forbidden != Forbidden::Zero {
            return false;
        }
        let series = &block[self.of];
        let changes = largest_changes(series, lengths);
        let mut is_far = true;
        for lane in 0..N {
            is_far &= WITH_BLUR * changes[lane] < series[0][lane].abs();
        }
        is_far
    }

    /// The fraction of a step of this length, in units of the block, after which the value first reaches a forbidden value.
    pub(in crate::taylor) fn first_contact<const N: usize>(
        &self,
        block: &Block<N>,
        lane: usize,
        length: f64,
        tolerance: f64,
    ) -> Option<f64> {
        let series = scaled(block[self.of].iter().map(|c| c[lane]), length);
        let contact = |forbidden: f64| {
            let mut distance = series.clone();
            distance[0] -= forbidden;
            Stretch::new(&distance, tolerance).first_contact()
        };
        match self.forbidden {
            Forbidden::Zero => contact(0.0),
            Forbidden::OddQuarterTurns => {
                let below = PI * ((series[0] - FRAC_PI_2) / PI).floor() + FRAC_PI_2;
                [below, below + PI].into_iter().filter_map(contact).reduce(f64::min)
            }
        }
    }
}
