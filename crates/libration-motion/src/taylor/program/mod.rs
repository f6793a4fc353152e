//! The tape of a system as a list of instructions that act on a block of series.
//!
//! A `Jet` determines at every order which slots are constant, weighted or linear in the
//! time. Integrations evaluate the tape millions of times, so here this is determined once.

#[doc(hidden)]
pub(crate) mod expander;
pub(crate) mod linearised;
pub(in crate::taylor) mod machine_code;
pub(in crate::taylor) mod moduli;
pub(in crate::taylor) mod monomials;
pub(crate) mod open_signs;
pub(in crate::taylor) mod passage;
pub(in crate::taylor) mod plan;
pub(in crate::taylor) mod quotients;
pub(crate) mod state_names;
pub(in crate::taylor) mod straight_line;
pub(in crate::taylor) mod system;
pub(in crate::taylor) mod tangent;

use std::collections::{HashMap, HashSet};

use libration_jit::Compiled;

use crate::taylor::step::block::{Block, Row};
use libration_kernels::elementary::count;
use libration_numbers::internals::expression::{Evaluator, Instruction, Operation, Tape, Value, Weighted};
use libration_numbers::{
    algebra::{Function, Rational},
    internals::algebra::{Lanes, integral, lanes, quotient, sin_cos_in_lanes, square},
};

/// Instructions for the coefficients of the formulas on a tape.
#[derive(Clone, Debug)]
pub struct Program {
    /// Rows with the same values in all steps.
    pub(in crate::taylor) constants: Vec<(Row, f64)>,
    /// Instructions for the zeroth coefficients of functions, and of all their operands.
    functions: Vec<Zeroth>,
    /// Instructions for the zeroth coefficients of the other rows: sums, products and quotients.
    pub(in crate::taylor) arithmetic: Vec<Zeroth>,
    /// Rows with instructions for their zeroth coefficients.
    begun: Vec<Row>,
    /// Instructions for the first coefficients of rows that are linear in the time, whose higher coefficients vanish.
    linear: Vec<Instruction<Row, f64>>,
    /// Instructions for the higher coefficients of all other rows.
    nonlinear: Vec<Instruction<Row, f64>>,
    /// Rows of the formulas.
    pub(in crate::taylor) results: Vec<Row>,
    /// Rows of all slots of the tape.
    pub(in crate::taylor) places: Vec<Row>,
    /// Number of rows.
    pub(in crate::taylor) rows: usize,
}

/// An instruction for zeroth coefficients.
#[derive(Clone, Copy, Debug)]
pub(in crate::taylor) enum Zeroth {
    One { out: Row, value: Value<Row, f64> },
    Reciprocal { of: Row, out: Row },
    SineAndCosine { of: Row, sine: Row, cosine: Row },
}

/// The degree in the time of a row that is not known to be a polynomial.
const ENDLESS: usize = usize::MAX;

impl Program {
    /// The program of a tape whose inputs have these degrees in the time, for `terms`
    /// coefficients. Inputs come first in the block; `last` marks those which are known last.
    pub(in crate::taylor) fn new(tape: &Tape, degrees: &[usize], last: &[bool], terms: usize) -> Self {
        let program = Self {
            constants: vec![],
            functions: vec![],
            arithmetic: vec![],
            begun: vec![],
            linear: vec![],
            nonlinear: vec![],
            results: vec![],
            places: vec![],
            rows: tape.inputs(),
        };
        let (rows, input_degrees) = (vec![], degrees);
        let delays = delays(tape, last);
        let reciprocals = HashMap::new();
        let (degrees, values) = (vec![], vec![]);
        let mut writer = Writer {
            tape,
            terms,
            program,
            values,
            places: rows,
            degrees,
            delays,
            reciprocals,
            input_degrees,
        };
        for slot in 0..tape.operations().len() {
            writer.write(slot);
        }
        (writer.program.functions, writer.program.arithmetic) = with_functions_first(&writer.values);
        writer.program.places = writer.places.iter().map(|row| row.plain).collect();
        writer.program.results = tape.results().iter().map(|&slot| writer.places[slot].plain).collect();
        writer.program
    }

    /// Computes the zeroth coefficients, given those of the inputs.
    #[inline(always)]
    pub fn begin<const N: usize>(&self, block: &mut Block<N>, arithmetic: Option<&Compiled>) {
        begin_rows(&self.functions, block);
        match arithmetic {
            Some(compiled) => block.run(compiled),
            None => begin_rows(&self.arithmetic, block),
        }
    }

    /// Copies the zeroth coefficients of another block.
    pub(in crate::taylor) fn begin_as<const N: usize>(&self, other: &Block<N>, block: &mut Block<N>) {
        for &row in &self.begun {
            *block.zeroth_mut(row) = *other.zeroth(row);
        }
    }

    /// Computes the n-th coefficients, given those of the inputs.
    #[inline(always)]
    pub(in crate::taylor) fn extend<const N: usize>(&self, block: &mut Block<N>, n: usize) {
        for instruction in self.instructions(n) {
            carry_out(instruction, block, n);
        }
    }

    /// The instructions for the n-th coefficients, in order.
    #[inline(always)]
    pub(in crate::taylor) fn instructions(&self, n: usize) -> impl Iterator<Item = &Instruction<Row, f64>> {
        let linear: &[_] = if n == 1 { &self.linear } else { &[] };
        linear.iter().chain(&self.nonlinear)
    }
}

#[inline(always)]
fn begin_rows<const N: usize>(zeroth: &[Zeroth], block: &mut Block<N>) {
    for zeroth in zeroth {
        match *zeroth {
            Zeroth::One { out, value } => block[out][0] = value_or_nan(value.evaluate(block)),
            Zeroth::Reciprocal { of, out } => {
                block[out][0] = lanes(|lane| 1.0 / block[of][0][lane]);
            }
            Zeroth::SineAndCosine { of, sine, cosine } => {
                [block[sine][0], block[cosine][0]] = sin_cos_in_lanes(&block[of][0]);
            }
        }
    }
}

/// Splits the instructions into functions with their operands, and the others, each in their order.
fn with_functions_first(values: &[Zeroth]) -> (Vec<Zeroth>, Vec<Zeroth>) {
    let mut needed = HashSet::new();
    let mut is_first = vec![false; values.len()];
    for (zeroth, is_first) in values.iter().zip(&mut is_first).rev() {
        let (is_function, out, operands) = match *zeroth {
            Zeroth::One { out, value } => (value.is_function(), out, value.operands()),
            Zeroth::Reciprocal { of, out } => (false, out, [Some(of), None]),
            Zeroth::SineAndCosine { of, sine, .. } => (true, sine, [Some(of), None]),
        };
        *is_first = is_function || needed.contains(&out);
        needed.extend(operands.into_iter().flatten().filter(|_| *is_first));
    }
    let part = |first: bool| {
        let chosen = values.iter().zip(&is_first).filter(move |(_, is_first)| **is_first == first);
        chosen.map(|(zeroth, _)| *zeroth).collect()
    };
    (part(true), part(false))
}

#[inline(always)]
fn carry_out<const N: usize>(instruction: &Instruction<Row, f64>, block: &mut Block<N>, n: usize) {
    // In lanes every instruction has a value, possibly NaN.
    if let Some((out, value)) = instruction.evaluate(block, n) {
        block[out][n] = value;
    }
}

impl<const N: usize> Evaluator<Row, f64> for Block<N> {
    type Ring = Lanes<N>;

    #[inline(always)]
    fn ring(&self) -> &Lanes<N> {
        &Lanes
    }

    #[inline(always)]
    fn row(&self, row: Row) -> &[[f64; N]] {
        &self[row]
    }

    #[inline(always)]
    fn exponent(&self, exponent: &f64) -> Option<[f64; N]> {
        Some([*exponent; N])
    }

    #[inline(always)]
    fn power(&self, base: &[f64; N], exponent: &f64) -> Option<[f64; N]> {
        Some(lanes(|lane| libm::pow(base[lane], *exponent)))
    }

    #[inline(always)]
    fn square(&self, a: &[[f64; N]]) -> [f64; N] {
        square(&Lanes, a)
    }

    #[inline(always)]
    fn quotient(&self, a_n: &[f64; N], c: &[[f64; N]], b: &[[f64; N]]) -> Option<[f64; N]> {
        quotient(&Lanes, *a_n, c, b)
    }

    #[inline(always)]
    fn integral(&self, a_n: &[f64; N], weighted_a: &[[f64; N]], b: &[[f64; N]]) -> Option<[f64; N]> {
        integral(&Lanes, *a_n, weighted_a, b)
    }

    #[inline(always)]
    fn begins_beyond(&self, exponent: &f64, n: usize) -> bool {
        begins_beyond(*exponent, n)
    }

    #[inline(always)]
    fn over_base(&self, value: &[f64; N], base: &[f64; N], begins_later: bool) -> Option<[f64; N]> {
        let over = |lane: usize| value[lane] / base[lane];
        Some(lanes(|lane| if begins_later && base[lane] == 0.0 { 0.0 } else { over(lane) }))
    }
}

/// Returns `true` if a power of a series that begins with zero has no coefficient n yet.
#[inline(always)]
pub(in crate::taylor) fn begins_beyond(exponent: f64, n: usize) -> bool {
    exponent.fract() == 0.0 && count(n) < exponent
}

#[inline(always)]
fn value_or_nan<const N: usize>(value: Option<[f64; N]>) -> [f64; N] {
    value.unwrap_or([f64::NAN; N])
}

/// Writes a program from the first operation of a tape to the last.
struct Writer<'a> {
    tape: &'a Tape,
    /// Number of coefficients in a row.
    terms: usize,
    program: Program,
    /// Instructions for the zeroth coefficients.
    values: Vec<Zeroth>,
    /// Rows of the results.
    places: Vec<Weighted<Row>>,
    /// Degrees of the results in the time.
    degrees: Vec<usize>,
    /// Delay after which each result is known at an order, in operations.
    delays: Vec<usize>,
    /// Rows of the reciprocals of constant divisors.
    reciprocals: HashMap<usize, Row>,
    input_degrees: &'a [usize],
}

/// The number of operations between the values that are known first at an order and each result, if the inputs marked `last` are known last.
fn delays(tape: &Tape, last: &[bool]) -> Vec<usize> {
    /// An upper bound on the number of operations between two orders.
    const ORDER: usize = 1000;
    let mut delays: Vec<usize> = vec![];
    for operation in tape.operations() {
        let before = operation.operands().map(|slot| delays[slot] + 1).max().unwrap_or(0);
        let is_last = matches!(*operation, Operation::Input(number) if last.get(number) == Some(&true));
        delays.push(if is_last { ORDER } else { before });
    }
    delays
}

impl Writer<'_> {
    fn row(&mut self) -> Row {
        self.program.rows += 1;
        Row::new(self.program.rows - 1, self.terms)
    }

    /// The next row.
    fn next_row(&self) -> Row {
        Row::new(self.program.rows, self.terms)
    }

    fn write(&mut self, slot: usize) {
        let operation = &self.tape.operations()[slot];
        let degree = self.degree(operation);
        let plain =
            if let Operation::Input(number) = *operation { Row::new(number, self.terms) } else { self.row() };
        let weighted = if self.tape.is_weighted(slot) { self.row() } else { plain };
        self.places.push(Weighted { plain, weighted });
        self.degrees.push(degree);
        self.write_value(operation, plain);
        if degree > 0 {
            self.prepare_divisor(operation);
            let instruction = self.instruction(operation, slot);
            let weight = (weighted != plain).then_some(Instruction::Weight { a: plain, out: weighted });
            let list = if degree == 1 { &mut self.program.linear } else { &mut self.program.nonlinear };
            list.extend(instruction.into_iter().chain(weight));
        }
    }

    fn prepare_divisor(&mut self, operation: &Operation) {
        if let Operation::Divide(_, divisor) = *operation
            && self.degrees[divisor] == 0
            && !self.reciprocals.contains_key(&divisor)
        {
            let (of, out) = (self.places[divisor].plain, self.row());
            self.values.push(Zeroth::Reciprocal { of, out });
            self.program.begun.push(out);
            self.reciprocals.insert(divisor, out);
        }
    }

    /// The degree of a result in the time.
    fn degree(&self, operation: &Operation) -> usize {
        let of = |slot: usize| self.degrees[slot];
        let constant_or_endless = |degree: usize| if degree == 0 { 0 } else { ENDLESS };
        match *operation {
            Operation::Number(_) | Operation::Pi => 0,
            Operation::Input(number) => self.input_degrees[number],
            Operation::Negate(a) => of(a),
            Operation::Add(a, b) | Operation::Subtract(a, b) => of(a).max(of(b)),
            Operation::Multiply(a, b) if of(a) == 0 || of(b) == 0 => of(a).max(of(b)),
            Operation::Divide(a, b) if of(b) == 0 => of(a),
            Operation::Multiply(a, b) | Operation::Divide(a, b) => constant_or_endless(of(a).max(of(b))),
            Operation::Power(a, _)
            | Operation::Exp(a)
            | Operation::Abs(a)
            | Operation::Sign(a)
            | Operation::Paired { of: a, .. }
            | Operation::Tangent { of: a, .. }
            | Operation::Inverse { of: a, .. } => constant_or_endless(of(a)),
        }
    }

    fn write_value(&mut self, operation: &Operation, out: Row) {
        match *operation {
            Operation::Number(ref number) => self.program.constants.push((out, number.to_f64())),
            Operation::Pi => self.program.constants.push((out, std::f64::consts::PI)),
            _ => {
                let value = Value::new(operation, |slot| self.places[slot].plain, Rational::to_f64);
                if let Some(value) = value {
                    self.push_value(out, value);
                }
            }
        }
    }

    /// The cosine of an argument is computed together with its sine, in the row after it.
    fn push_value(&mut self, out: Row, value: Value<Row, f64>) {
        self.program.begun.push(out);
        let values = &mut self.values;
        let pair = match (values.last(), value) {
            (
                Some(&Zeroth::One { out: sine, value: Value::Of(Function::Sin, of) }),
                Value::Of(Function::Cos, same),
            ) if of == same => {
                values.pop();
                Some(Zeroth::SineAndCosine { of, sine, cosine: out })
            }
            _ => None,
        };
        values.push(pair.unwrap_or(Zeroth::One { out, value }));
    }

    /// The instruction for an operation; `None` for inputs and constants.
    fn instruction(&self, operation: &Operation, slot: usize) -> Option<Instruction<Row, f64>> {
        // On the tape, absolute values and signs are products with signs, which are inputs.
        if matches!(operation, Operation::Abs(_) | Operation::Sign(_)) {
            return None;
        }
        // The rows after a slot's row are reserved before they are written.
        let next = Weighted { plain: self.next_row(), weighted: self.next_row() };
        let rows = |operand: usize| self.places.get(operand).copied().unwrap_or(next);
        let swapped = match *operation {
            // The newest coefficient of the first factor enters last. Double pendulums
            // at 1e-12, single or two hundred side by side, take 0.96 of the time.
            Operation::Multiply(a, b) if self.delays[a] < self.delays[b] => Some(Operation::Multiply(b, a)),
            _ => None,
        };
        let operation = swapped.as_ref().unwrap_or(operation);
        let reciprocal = |operand: usize| self.reciprocals.get(&operand).copied();
        Instruction::new(operation, slot, rows, reciprocal, |operand| self.degrees[operand], Rational::to_f64)
    }
}
