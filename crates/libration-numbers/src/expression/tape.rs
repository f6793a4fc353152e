//! A formula as a list of elementary operations, which any ring of coefficients can evaluate.

use std::collections::HashMap;

use super::simplify::has_too_many_bits;
use super::{Expression, Function, Symbol};
use crate::algebra::{Divisor, Pair, Rational, Rationals, Ring, Rule, Slope};

/// One operation; its operands are positions of earlier operations. A position holds the result of its operation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// The input with this index.
    Input(usize),
    Number(Rational),
    Pi,
    Negate(usize),
    Add(usize, usize),
    Subtract(usize, usize),
    Multiply(usize, usize),
    Divide(usize, usize),
    /// A power whose exponent is not a natural number.
    Power(usize, Rational),
    Exp(usize),
    /// One function of a pair: `of` is its argument, and its derivative is `slope` times the other function.
    Paired {
        function: Function,
        of: usize,
        other: usize,
        slope: Slope,
    },
    /// tan or tanh, whose square stands at the next position.
    Tangent {
        function: Function,
        of: usize,
    },
    /// ln, asin, acos, atan: the derivative is that of `of` divided by the value at `divisor`.
    Inverse {
        function: Function,
        of: usize,
        divisor: usize,
    },
    Abs(usize),
    Sign(usize),
}

/// Formulas of the same inputs as one list of operations without repetitions.
#[derive(Clone, Debug)]
pub struct Tape {
    operations: Vec<Operation>,
    results: Vec<usize>,
    inputs: usize,
    /// `true` for positions that do not depend on an input.
    constant: Vec<bool>,
    /// `true` for positions whose weighted series is needed.
    weighted: Vec<bool>,
}

/// A symbol in a formula that has no value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` has no value: give it one, such as {0}=0.1")]
pub struct WithoutValue(pub String);

impl Tape {
    /// The tape of these formulas in the given inputs.
    pub fn new(formulas: &[&Expression], inputs: &[Symbol]) -> Result<Self, WithoutValue> {
        let mut writer = Writer { inputs, operations: vec![], places: HashMap::new() };
        let results = formulas.iter().map(|formula| writer.write(formula)).collect::<Result<_, _>>()?;
        let operations = writer.operations;
        let constant = constant_places(&operations);
        let weighted = weighted_places(&operations);
        Ok(Self { operations, results, inputs: inputs.len(), constant, weighted })
    }

    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Positions of the values of the formulas.
    pub fn results(&self) -> &[usize] {
        &self.results
    }

    /// The positions that an operation reads.
    pub fn operands(&self, position: usize) -> Vec<usize> {
        self.operations[position].operands().collect()
    }

    pub fn inputs(&self) -> usize {
        self.inputs
    }

    pub fn is_constant(&self, position: usize) -> bool {
        self.constant[position]
    }

    pub fn is_weighted(&self, position: usize) -> bool {
        self.weighted[position]
    }
}

impl Operation {
    /// The positions that the operation reads.
    pub fn operands(&self) -> impl Iterator<Item = usize> + use<> {
        let operands = match *self {
            Self::Input(_) | Self::Number(_) | Self::Pi => [None; 2],
            Self::Negate(a)
            | Self::Power(a, _)
            | Self::Exp(a)
            | Self::Abs(a)
            | Self::Sign(a)
            | Self::Tangent { of: a, .. }
            | Self::Paired { of: a, .. } => [Some(a), None],
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Inverse { of: a, divisor: b, .. } => [Some(a), Some(b)],
        };
        operands.into_iter().flatten()
    }
}

fn constant_places(operations: &[Operation]) -> Vec<bool> {
    let mut constant: Vec<bool> = vec![];
    for operation in operations {
        let input = matches!(operation, Operation::Input(_));
        constant.push(!input && operation.operands().all(|operand| constant[operand]));
    }
    constant
}

fn weighted_places(operations: &[Operation]) -> Vec<bool> {
    let mut weighted = vec![false; operations.len()];
    for (position, operation) in operations.iter().enumerate() {
        match *operation {
            Operation::Power(a, _) | Operation::Inverse { of: a, .. } => {
                weighted[a] = true;
                weighted[position] = true;
            }
            Operation::Exp(a) | Operation::Tangent { of: a, .. } | Operation::Paired { of: a, .. } => {
                weighted[a] = true;
            }
            _ => {}
        }
    }
    weighted
}

struct Writer<'a> {
    inputs: &'a [Symbol],
    operations: Vec<Operation>,
    places: HashMap<Operation, usize>,
}

impl Writer<'_> {
    fn position_of(&mut self, operation: Operation) -> usize {
        let operation = self.folded(operation);
        if let Some(&position) = self.places.get(&operation) {
            return position;
        }
        let position = self.operations.len();
        self.operations.push(operation.clone());
        self.places.insert(operation, position);
        position
    }

    fn number(&mut self, value: i64) -> usize {
        self.position_of(Operation::Number(Rational::from(value)))
    }

    fn number_at(&self, position: usize) -> Option<&Rational> {
        if let Operation::Number(value) = &self.operations[position] { Some(value) } else { None }
    }

    /// The operation after arithmetic of numbers; factors of one and terms of zero are removed.
    fn folded(&self, operation: Operation) -> Operation {
        let two = |a: usize, b: usize| Some((self.number_at(a)?, self.number_at(b)?));
        let value = match operation {
            Operation::Negate(a) => self.number_at(a).map(|a| Rationals.negate(a)),
            Operation::Add(a, b) => two(a, b).map(|(a, b)| Rationals.add(a, b)),
            Operation::Subtract(a, b) => two(a, b).map(|(a, b)| Rationals.subtract(a, b)),
            Operation::Multiply(a, b) => two(a, b).map(|(a, b)| Rationals.multiply(a, b)),
            Operation::Divide(a, b) => two(a, b).and_then(|(a, b)| a.checked_div(b)),
            Operation::Power(a, ref exponent) => self.number_at(a).and_then(|a| Rationals.power(a, exponent)),
            _ => None,
        };
        value.map_or(operation, Operation::Number)
    }

    fn write(&mut self, formula: &Expression) -> Result<usize, WithoutValue> {
        let operation = match formula {
            Expression::Number(value) => Operation::Number(value.clone()),
            Expression::Pi => Operation::Pi,
            Expression::Symbol(symbol) => {
                let input = self.inputs.iter().position(|input| input == symbol);
                Operation::Input(input.ok_or_else(|| WithoutValue(symbol.name.clone()))?)
            }
            Expression::Negate(a) => Operation::Negate(self.write(a)?),
            Expression::Add(a, b) => Operation::Add(self.write(a)?, self.write(b)?),
            Expression::Subtract(a, b) => Operation::Subtract(self.write(a)?, self.write(b)?),
            Expression::Multiply(a, b) => Operation::Multiply(self.write(a)?, self.write(b)?),
            Expression::Divide(a, b) => Operation::Divide(self.write(a)?, self.write(b)?),
            Expression::Power(a, b) => return self.write_power(a, b),
            Expression::Call(function, a) => {
                let of = self.write(a)?;
                return Ok(self.function(*function, of));
            }
        };
        Ok(self.position_of(operation))
    }

    fn write_power(&mut self, base: &Expression, exponent: &Expression) -> Result<usize, WithoutValue> {
        let (base, exponent) = (self.write(base)?, self.write(exponent)?);
        let Some(number) = self.number_at(exponent).cloned() else {
            let logarithm = self.function(Function::Ln, base);
            let product = self.position_of(Operation::Multiply(exponent, logarithm));
            return Ok(self.position_of(Operation::Exp(product)));
        };
        Ok(self.fixed_power(base, number))
    }

    /// Largest exponent for which a power is computed by products; larger ones use the recurrence of powers.
    const LARGEST_PRODUCT: u64 = 1 << 12;

    fn fixed_power(&mut self, base: usize, exponent: Rational) -> usize {
        // The powers of a ring have limits, its products have none.
        let is_long = |n| self.number_at(base).is_some_and(|base| has_too_many_bits(base, n));
        let natural =
            exponent.magnitude().to_natural().filter(|&n| n <= Self::LARGEST_PRODUCT && !is_long(n));
        match natural {
            Some(n) if exponent.is_negative() => {
                let (one, power) = (self.number(1), self.natural_power(base, n));
                self.position_of(Operation::Divide(one, power))
            }
            Some(n) => self.natural_power(base, n),
            None => self.position_of(Operation::Power(base, exponent)),
        }
    }

    fn natural_power(&mut self, base: usize, n: u64) -> usize {
        match n {
            0 => self.number(1),
            1 => base,
            _ => {
                let half = self.natural_power(base, n / 2);
                let square = self.position_of(Operation::Multiply(half, half));
                if n.is_multiple_of(2) { square } else { self.position_of(Operation::Multiply(square, base)) }
            }
        }
    }

    fn function(&mut self, function: Function, of: usize) -> usize {
        if let Some(value) = self.number_at(of).and_then(|at| Rationals.value(function, at)) {
            return self.position_of(Operation::Number(value));
        }
        match function.rule() {
            Rule::Root => {
                let half = Rational::new(1, 2).expect("two is not zero");
                self.position_of(Operation::Power(of, half))
            }
            Rule::Itself => self.position_of(Operation::Exp(of)),
            Rule::Modulus => self.position_of(Operation::Abs(of)),
            Rule::Step => self.position_of(Operation::Sign(of)),
            Rule::Paired(pair) => {
                let (first, second) = self.pair(pair, of);
                if function == pair.functions[0] { first } else { second }
            }
            Rule::Quotient(_) => self.tangent(function, of),
            Rule::Inverse(slope, divisor) => {
                let divisor = self.divisor(divisor, of);
                let divisor =
                    if slope == Slope::Plus { divisor } else { self.position_of(Operation::Negate(divisor)) };
                self.position_of(Operation::Inverse { function, of, divisor })
            }
        }
    }

    /// The derivative of the first function is the second; that of the second is the first, with a sign.
    fn pair(&mut self, Pair { functions: [first, second], slope }: Pair, of: usize) -> (usize, usize) {
        let next = self.operations.len();
        let (function, plus) = (first, Slope::Plus);
        let wanted = Operation::Paired { function, of, other: next + 1, slope: plus };
        let same = |operation: &Operation| matches!(operation, Operation::Paired { function: f, of: a, .. } if *f == first && *a == of);
        if let Some(position) = self.operations.iter().position(same) {
            return (position, position + 1);
        }
        self.operations.push(wanted);
        self.operations.push(Operation::Paired { function: second, of, other: next, slope });
        (next, next + 1)
    }

    fn tangent(&mut self, function: Function, of: usize) -> usize {
        let operation = Operation::Tangent { function, of };
        if let Some(&position) = self.places.get(&operation) {
            return position;
        }
        let position = self.operations.len();
        self.operations.push(operation.clone());
        self.places.insert(operation, position);
        self.operations.push(Operation::Multiply(position, position));
        position
    }

    fn divisor(&mut self, divisor: Divisor, of: usize) -> usize {
        if divisor == Divisor::Argument {
            return of;
        }
        let (one, square) = (self.number(1), self.position_of(Operation::Multiply(of, of)));
        if divisor == Divisor::OneAndSquare {
            return self.position_of(Operation::Add(one, square));
        }
        let under = self.position_of(Operation::Subtract(one, square));
        self.function(Function::Sqrt, under)
    }
}
