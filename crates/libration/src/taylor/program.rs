//! The tape of a system as a list of instructions that go through a block of series.
//!
//! A `Jet` asks at every order what is constant, weighted or linear in the time. Integrations go through the tape millions
//! of times, so here that is asked once.

use super::block::{Block, Row};
use crate::algebra::{Doubles, Function, Lanes, Ring, Slope, lanes};
use crate::expression::{Operation, Tape};
use crate::series::recurrences::{
    Both, quotient, weighted_integral, weighted_integral_of_quotient, weighted_power,
};

/// Instructions for the coefficients of the formulas on a tape.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// Rows that are the same in all steps.
    pub(super) constants: Vec<(Row, f64)>,
    /// How the zeroth coefficients of the other rows come about.
    values: Vec<(Row, Value)>,
    /// How the next ones do where the row is linear in the time, and its other coefficients vanish.
    linear: Vec<Instruction>,
    /// How they do elsewhere.
    nonlinear: Vec<Instruction>,
    /// Where the formulas are.
    pub(super) results: Vec<Row>,
    /// Where all places of the tape are.
    pub(super) places: Vec<Row>,
    /// How many rows there are.
    pub(super) rows: usize,
}

/// How a zeroth coefficient comes about.
#[derive(Clone, Copy, Debug)]
enum Value {
    Negate(Row),
    Add(Row, Row),
    Subtract(Row, Row),
    Multiply(Row, Row),
    Divide(Row, Row),
    Power(Row, f64),
    Of(Function, Row),
}

/// How the next coefficient of a row comes about. A weighted row holds n times the coefficients of another.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Weight {
        a: Row,
        out: Row,
    },
    Negate {
        a: Row,
        out: Row,
    },
    Add {
        a: Row,
        b: Row,
        out: Row,
    },
    Subtract {
        a: Row,
        b: Row,
        out: Row,
    },
    /// A factor that does not depend on the time.
    Scale {
        factor: Row,
        a: Row,
        out: Row,
    },
    Multiply {
        a: Row,
        b: Row,
        out: Row,
    },
    /// A divisor that does not depend on the time.
    Unscale {
        a: Row,
        divisor: Row,
        out: Row,
    },
    Divide {
        a: Row,
        b: Row,
        out: Row,
    },
    Power {
        exponent: f64,
        a: Weighted,
        out: Weighted,
    },
    Exp {
        a: Row,
        out: Row,
    },
    /// The derivative is `other`, with a sign, times that of a series of this degree.
    Paired {
        a: Row,
        degree: usize,
        other: Row,
        slope: Slope,
        out: Row,
    },
    Tangent {
        function: Function,
        a: Row,
        square: Row,
        out: Row,
    },
    Inverse {
        a: Row,
        divisor: Row,
        out: Weighted,
    },
}

/// A row and its weighted form.
#[derive(Clone, Copy, Debug)]
struct Weighted {
    plain: Row,
    weighted: Row,
}

/// The degree in the time of what is not known to be a polynomial.
const ENDLESS: usize = usize::MAX;

impl Program {
    /// The program of a tape, the inputs of which have these degrees in the time, for so many coefficients. Inputs come first
    /// in the block.
    pub(super) fn new(tape: &Tape, degrees: &[usize], terms: usize) -> Self {
        let program = Self {
            constants: vec![],
            values: vec![],
            linear: vec![],
            nonlinear: vec![],
            results: vec![],
            places: vec![],
            rows: tape.inputs(),
        };
        let (places, input_degrees) = (vec![], degrees);
        let mut writer = Writer { tape, terms, program, places, degrees: vec![], input_degrees };
        for place in 0..tape.operations().len() {
            writer.write(place);
        }
        writer.program.places = writer.places.iter().map(|place| place.plain).collect();
        writer.program.results = tape.results().iter().map(|&place| writer.places[place].plain).collect();
        writer.program
    }

    /// The zeroth coefficients, those of the inputs being known.
    #[inline(always)]
    pub(super) fn begin<const N: usize>(&self, block: &mut Block<N>) {
        for &(out, value) in &self.values {
            block[out][0] = zeroth(value, block);
        }
    }

    /// Those that another block has.
    pub(super) fn begin_as<const N: usize>(&self, other: &Block<N>, block: &mut Block<N>) {
        for &(out, _) in &self.values {
            block[out][0] = other[out][0];
        }
    }

    /// The n-th coefficients, those of the inputs being known.
    #[inline(always)]
    pub(super) fn extend<const N: usize>(&self, block: &mut Block<N>, n: usize) {
        if n == 1 {
            for &instruction in &self.linear {
                obey(instruction, block, n);
            }
        }
        for &instruction in &self.nonlinear {
            obey(instruction, block, n);
        }
    }
}

#[inline(always)]
fn zeroth<const N: usize>(value: Value, block: &Block<N>) -> [f64; N] {
    let at = |row: Row| &block[row][0];
    match value {
        Value::Negate(a) => lanes(|lane| -at(a)[lane]),
        Value::Add(a, b) => lanes(|lane| at(a)[lane] + at(b)[lane]),
        Value::Subtract(a, b) => lanes(|lane| at(a)[lane] - at(b)[lane]),
        Value::Multiply(a, b) => lanes(|lane| at(a)[lane] * at(b)[lane]),
        Value::Divide(a, b) => lanes(|lane| at(a)[lane] / at(b)[lane]),
        Value::Power(a, exponent) => lanes(|lane| libm::pow(at(a)[lane], exponent)),
        Value::Of(function, a) => lanes(|lane| Doubles.value(function, &at(a)[lane]).unwrap_or(f64::NAN)),
    }
}

#[inline(always)]
fn obey<const N: usize>(instruction: Instruction, block: &mut Block<N>, n: usize) {
    let ring = &Lanes::<N>;
    let at = |row: Row| &block[row][n];
    let before = |row: Row| &block[row][..n];
    let through = |row: Row| &block[row][..=n];
    let behind = |row: Row| &block[row][1..=n];
    let over_n = |weighted: [f64; N]| over_integer(&weighted, n);
    let (out, value) = match instruction {
        Instruction::Weight { a, out } => (out, weighted(at(a), n)),
        Instruction::Negate { a, out } => (out, lanes(|lane| -at(a)[lane])),
        Instruction::Add { a, b, out } => (out, lanes(|lane| at(a)[lane] + at(b)[lane])),
        Instruction::Subtract { a, b, out } => (out, lanes(|lane| at(a)[lane] - at(b)[lane])),
        Instruction::Scale { factor, a, out } => (out, lanes(|lane| block[factor][0][lane] * at(a)[lane])),
        Instruction::Multiply { a, b, out } => (out, ring.convolution(through(a), through(b))),
        Instruction::Unscale { a, divisor, out } => {
            (out, lanes(|lane| at(a)[lane] / block[divisor][0][lane]))
        }
        Instruction::Divide { a, b, out } => (out, known(quotient(ring, at(a), before(out), through(b)))),
        Instruction::Power { exponent, a, out } => {
            let own = Both { plain: before(out.plain), weighted: before(out.weighted) };
            let of = Both { plain: through(a.plain), weighted: through(a.weighted) };
            let value = weighted_power(ring, &[exponent; N], of, own);
            let base = block[a.plain][0];
            // A whole power of what begins with zero begins beyond that power.
            let later = exponent.fract() == 0.0 && weighted(&[1.0; N], n)[0] < exponent;
            let divided =
                |lane: usize| if later && base[lane] == 0.0 { 0.0 } else { value[lane] / base[lane] };
            (out.plain, over_n(lanes(divided)))
        }
        Instruction::Exp { a, out } => (out, over_n(weighted_integral(ring, behind(a), before(out)))),
        Instruction::Paired { a, degree, other, slope, out } => {
            let terms = degree.min(n);
            let value = weighted_integral(ring, &block[a][1..=terms], &block[other][n - terms..n]);
            (out, over_n(if slope == Slope::Plus { value } else { lanes(|lane| -value[lane]) }))
        }
        Instruction::Tangent { function, a, square, out } => {
            let (own, driven) = (at(a), weighted_integral(ring, behind(a), before(square)));
            let sign = if function == Function::Tan { 1.0 } else { -1.0 };
            (out, over_n(lanes(|lane| own[lane] + sign * driven[lane])))
        }
        Instruction::Inverse { a, divisor, out } => {
            let own = &block[out.weighted][1..n];
            (out.plain, over_n(known(weighted_integral_of_quotient(ring, at(a), own, before(divisor)))))
        }
    };
    block[out][n] = value;
}

#[inline(always)]
fn known<const N: usize>(value: Option<[f64; N]>) -> [f64; N] {
    value.unwrap_or([f64::NAN; N])
}

#[inline(always)]
#[expect(clippy::cast_precision_loss, reason = "orders are small")]
fn weighted<const N: usize>(a: &[f64; N], n: usize) -> [f64; N] {
    lanes(|lane| a[lane] * n as f64)
}

#[inline(always)]
pub(super) fn over_integer<const N: usize>(a: &[f64; N], n: usize) -> [f64; N] {
    known(Lanes.over_integer(a, u64::try_from(n).unwrap_or(u64::MAX)))
}

/// Writes a program from the first operation of a tape to the last.
struct Writer<'a> {
    tape: &'a Tape,
    /// How many coefficients a row has.
    terms: usize,
    program: Program,
    /// Where results are.
    places: Vec<Weighted>,
    /// Their degrees in the time.
    degrees: Vec<usize>,
    input_degrees: &'a [usize],
}

impl Writer<'_> {
    fn row(&mut self) -> Row {
        self.program.rows += 1;
        Row::new(self.program.rows - 1, self.terms)
    }

    /// The one that comes next.
    fn next_row(&self) -> Row {
        Row::new(self.program.rows, self.terms)
    }

    fn write(&mut self, place: usize) {
        let operation = &self.tape.operations()[place];
        let degree = self.degree(operation);
        let plain =
            if let Operation::Input(number) = *operation { Row::new(number, self.terms) } else { self.row() };
        let weighted = if self.tape.is_weighted(place) { self.row() } else { plain };
        self.places.push(Weighted { plain, weighted });
        self.degrees.push(degree);
        self.write_value(operation, plain);
        if degree > 0 {
            let instruction = self.instruction(operation, place);
            let weight = (weighted != plain).then_some(Instruction::Weight { a: plain, out: weighted });
            let list = if degree == 1 { &mut self.program.linear } else { &mut self.program.nonlinear };
            list.extend(instruction.into_iter().chain(weight));
        }
    }

    /// The degree of a result in the time.
    fn degree(&self, operation: &Operation) -> usize {
        let of = |place: usize| self.degrees[place];
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
        let at = |place: usize| self.places[place].plain;
        let value = match *operation {
            Operation::Input(_) => return,
            Operation::Number(ref number) => return self.program.constants.push((out, number.to_f64())),
            Operation::Pi => return self.program.constants.push((out, std::f64::consts::PI)),
            Operation::Negate(a) => Value::Negate(at(a)),
            Operation::Add(a, b) => Value::Add(at(a), at(b)),
            Operation::Subtract(a, b) => Value::Subtract(at(a), at(b)),
            Operation::Multiply(a, b) => Value::Multiply(at(a), at(b)),
            Operation::Divide(a, b) => Value::Divide(at(a), at(b)),
            Operation::Power(a, ref exponent) => Value::Power(at(a), exponent.to_f64()),
            Operation::Exp(a) => Value::Of(Function::Exp, at(a)),
            Operation::Abs(a) => Value::Of(Function::Abs, at(a)),
            Operation::Sign(a) => Value::Of(Function::Sign, at(a)),
            Operation::Paired { function, of, .. }
            | Operation::Tangent { function, of }
            | Operation::Inverse { function, of, .. } => Value::Of(function, at(of)),
        };
        self.program.values.push((out, value));
    }

    /// `None` for what is given or constant.
    fn instruction(&self, operation: &Operation, place: usize) -> Option<Instruction> {
        let at = |place: usize| self.places[place].plain;
        let weighted = |place: usize| self.places[place].weighted;
        let constant = |place: usize| self.degrees[place] == 0;
        let out = at(place);
        Some(match *operation {
            // Absolute values and signs are on the tape as signs among the inputs.
            Operation::Input(_)
            | Operation::Number(_)
            | Operation::Pi
            | Operation::Abs(_)
            | Operation::Sign(_) => return None,
            Operation::Negate(a) => Instruction::Negate { a: at(a), out },
            Operation::Add(a, b) => Instruction::Add { a: at(a), b: at(b), out },
            Operation::Subtract(a, b) => Instruction::Subtract { a: at(a), b: at(b), out },
            Operation::Multiply(a, b) if constant(a) => Instruction::Scale { factor: at(a), a: at(b), out },
            Operation::Multiply(a, b) if constant(b) => Instruction::Scale { factor: at(b), a: at(a), out },
            Operation::Multiply(a, b) => Instruction::Multiply { a: at(a), b: at(b), out },
            Operation::Divide(a, b) if constant(b) => Instruction::Unscale { a: at(a), divisor: at(b), out },
            Operation::Divide(a, b) => Instruction::Divide { a: at(a), b: at(b), out },
            Operation::Power(a, ref exponent) => {
                Instruction::Power { exponent: exponent.to_f64(), a: self.places[a], out: self.places[place] }
            }
            Operation::Exp(a) => Instruction::Exp { a: weighted(a), out },
            Operation::Paired { of, other, slope, .. } => {
                // The second of a pair comes behind the first, which is asked for its place before it is written.
                let other = if other < place { at(other) } else { self.next_row() };
                Instruction::Paired { a: weighted(of), degree: self.degrees[of], other, slope, out }
            }
            Operation::Tangent { function, of } => {
                let square = self.next_row();
                Instruction::Tangent { function, a: weighted(of), square, out }
            }
            Operation::Inverse { of, divisor, .. } => {
                Instruction::Inverse { a: weighted(of), divisor: at(divisor), out: self.places[place] }
            }
        })
    }
}
