//! Formulas in a state with their derivatives, and with bounds of the rounding errors of their values in double precision.

use libration_numbers::algebra::Function;
use libration_numbers::internals::algebra::Slope;
use libration_numbers::internals::expression::{Operation, Tape};

/// The largest relative rounding error of a number.
pub(crate) const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Half the distance to the next number; zero for zero, which is exact.
pub(in crate::taylor) fn half_ulp(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { 0.5 * (value.abs().next_up() - value.abs()) }
}

/// Some formulas of a tape, evaluated in one state after another.
#[derive(Clone, Debug)]
pub(crate) struct Linearised {
    tape: Tape,
    /// Number of inputs, the first ones of the tape, with respect to which the formulas are differentiated.
    numbers: usize,
    /// The operations on which the formulas depend and which depend on inputs.
    varying: Vec<usize>,
    values: Vec<f64>,
    /// Error bounds of the values, in units of [`ROUNDING`], for exact inputs.
    errors: Vec<f64>,
    /// Derivatives of each operation, one per such input.
    slopes: Vec<f64>,
}

/// The value of an operation, and its derivatives by its operands.
struct Differential {
    value: f64,
    /// The slots of the operands, and the derivatives with respect to them.
    by: [Option<(usize, f64)>; 2],
    is_exact: bool,
}

impl Linearised {
    /// Some formulas of a tape, with derivatives with respect to the first `numbers` inputs.
    pub(crate) fn new(tape: &Tape, formulas: impl Iterator<Item = usize>, numbers: usize) -> Self {
        let operations = tape.operations();
        let mut needed = vec![false; operations.len()];
        for formula in formulas {
            needed[tape.results()[formula]] = true;
        }
        for slot in (0..operations.len()).rev() {
            if let Operation::Paired { other, .. } = operations[slot] {
                needed[slot] |= needed[other];
                needed[other] |= needed[slot];
            }
            if needed[slot] {
                operations[slot].operands().for_each(|operand| needed[operand] = true);
            }
        }
        let varying = (0..operations.len()).filter(|&slot| needed[slot] && !tape.is_constant(slot));
        let mut linearised = Self {
            tape: tape.clone(),
            numbers,
            varying: varying.collect(),
            values: vec![0.0; operations.len()],
            errors: vec![0.0; operations.len()],
            slopes: vec![0.0; numbers * operations.len()],
        };
        for (slot, operation) in operations.iter().enumerate().filter(|(slot, _)| needed[*slot]) {
            match operation {
                Operation::Input(number) if *number < numbers => {
                    linearised.slopes[numbers * slot + number] = 1.0;
                }
                _ if tape.is_constant(slot) => linearised.evaluate_slot(slot, &[]),
                _ => {}
            }
        }
        linearised
    }

    /// The inputs that occur in the formulas.
    pub(in crate::taylor) fn inputs(&self) -> impl Iterator<Item = usize> + '_ {
        self.varying.iter().filter_map(|&slot| match self.tape.operations()[slot] {
            Operation::Input(input) => Some(input),
            _ => None,
        })
    }

    /// Evaluates the formulas for these inputs.
    pub(crate) fn evaluate(&mut self, inputs: &[f64]) {
        for number in 0..self.varying.len() {
            self.evaluate_slot(self.varying[number], inputs);
        }
    }

    /// The value of a formula.
    pub(crate) fn value(&self, formula: usize) -> f64 {
        self.values[self.tape.results()[formula]]
    }

    /// The bound of the rounding error of a formula.
    pub(crate) fn error(&self, formula: usize) -> f64 {
        ROUNDING * self.errors[self.tape.results()[formula]]
    }

    /// The derivatives of a formula.
    pub(crate) fn slopes(&self, formula: usize) -> &[f64] {
        let slot = self.tape.results()[formula];
        &self.slopes[self.numbers * slot..self.numbers * (slot + 1)]
    }

    fn evaluate_slot(&mut self, slot: usize, inputs: &[f64]) {
        let Differential { value, by, is_exact } = self.differential(slot, inputs);
        self.values[slot] = value;
        let inherited = |&(operand, slope): &(usize, f64)| {
            let error = self.errors[operand];
            if error > 0.0 { slope.abs() * error } else { 0.0 }
        };
        let inherited: f64 = by.iter().flatten().map(inherited).sum();
        let rounding = if is_exact { 0.0 } else { value.abs().max(self.underflow(slot)) };
        self.errors[slot] = inherited + rounding;
        let (before, rest) = self.slopes.split_at_mut(self.numbers * slot);
        let derivatives = &mut rest[..self.numbers];
        let of = |operand: usize| &before[self.numbers * operand..self.numbers * (operand + 1)];
        match by {
            [Some((a, by_a)), Some((b, by_b))] => {
                let slopes = derivatives.iter_mut().zip(of(a).iter().zip(of(b)));
                match by_a.is_finite() && by_b.is_finite() {
                    true => slopes.for_each(|(sum, (a, b))| *sum = by_a * a + by_b * b),
                    false => slopes.for_each(|(sum, (a, b))| *sum = times(by_a, *a) + times(by_b, *b)),
                }
            }
            [Some((a, by_a)), None] => {
                derivatives.iter_mut().zip(of(a)).for_each(|(sum, a)| *sum = times(by_a, *a));
            }
            // The values of inputs and numbers do not change.
            _ => {}
        }
    }

    /// The least rounding error of an operation whose value may be below the range of numbers with all digits, in units of [`ROUNDING`].
    fn underflow(&self, slot: usize) -> f64 {
        let is_zero = |operand: usize| self.values[operand] == 0.0;
        match self.tape.operations()[slot] {
            Operation::Multiply(a, b) if is_zero(a) || is_zero(b) => 0.0,
            Operation::Divide(a, _) | Operation::Power(a, _) if is_zero(a) => 0.0,
            Operation::Multiply(..) | Operation::Divide(..) | Operation::Power(..) | Operation::Exp(_) => {
                f64::MIN_POSITIVE
            }
            _ => 0.0,
        }
    }

    fn differential(&mut self, slot: usize, inputs: &[f64]) -> Differential {
        let exact = |value: f64, by| Differential { value, by, is_exact: true };
        let rounded = |value: f64, by| Differential { value, by, is_exact: false };
        let at = |operand: usize| self.values[operand];
        match self.tape.operations()[slot] {
            Operation::Input(number) => exact(inputs[number], [None; 2]),
            Operation::Number(ref number) => {
                Differential { value: number.to_f64(), by: [None; 2], is_exact: number.is_double() }
            }
            Operation::Pi => rounded(std::f64::consts::PI, [None; 2]),
            Operation::Negate(a) => exact(-at(a), [Some((a, -1.0)), None]),
            Operation::Add(a, b) => rounded(at(a) + at(b), [Some((a, 1.0)), Some((b, 1.0))]),
            Operation::Subtract(a, b) => rounded(at(a) - at(b), [Some((a, 1.0)), Some((b, -1.0))]),
            Operation::Multiply(a, b) => rounded(at(a) * at(b), [Some((a, at(b))), Some((b, at(a)))]),
            Operation::Divide(a, b) => {
                let value = at(a) / at(b);
                rounded(value, [Some((a, 1.0 / at(b))), Some((b, -value / at(b)))])
            }
            Operation::Power(a, ref exponent) => {
                let exponent = exponent.to_f64();
                let slope = exponent * libm::pow(at(a), exponent - 1.0);
                rounded(libm::pow(at(a), exponent), [Some((a, slope)), None])
            }
            Operation::Exp(a) => {
                let value = Function::Exp.at_double(at(a));
                rounded(value, [Some((a, value)), None])
            }
            Operation::Paired { function, of, other, slope } => {
                let argument = at(of);
                let value = if other < slot { at(slot) } else { function.at_double(argument) };
                if other > slot
                    && let Operation::Paired { function, .. } = self.tape.operations()[other]
                {
                    self.values[other] = function.at_double(argument);
                }
                rounded(value, [Some((of, signed(slope, self.values[other]))), None])
            }
            Operation::Tangent { function, of } => {
                let value = function.at_double(at(of));
                let square = if function == Function::Tanh { -value * value } else { value * value };
                rounded(value, [Some((of, 1.0 + square)), None])
            }
            Operation::Inverse { function, of, divisor } => {
                rounded(function.at_double(at(of)), [Some((of, 1.0 / at(divisor))), None])
            }
            Operation::Abs(a) => exact(at(a).abs(), [Some((a, at(a).signum())), None]),
            Operation::Sign(a) => exact(Function::Sign.at_double(at(a)), [None; 2]),
        }
    }
}

/// The product of two derivatives; zero for an operand that does not depend on an input, even if the operation has an infinite derivative.
fn times(slope: f64, inner: f64) -> f64 {
    if inner == 0.0 { 0.0 } else { slope * inner }
}

fn signed(slope: Slope, value: f64) -> f64 {
    if slope == Slope::Plus { value } else { -value }
}
