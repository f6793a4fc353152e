//! The expansion of a system to an order as arithmetic without loops, obtained by recording its operations.

use std::cell::RefCell;
use std::collections::HashMap;

use libration_jit::{Arithmetic, MultiplyAdd, StraightLine, inner_product};

use super::expander::{Expander, rate};
use crate::taylor::program::{Zeroth, begins_beyond};
use crate::taylor::step::block::Row;
use libration_numbers::internals::expression::Evaluator;
use libration_numbers::{
    algebra::{Function, Rational, Ring},
    internals::algebra::{Rounded, convolution, integral, prepared_reciprocal, quotient, square},
};

impl Expander<'_> {
    /// The computation of the zeroth coefficients, given those of functions; `None` if machine code is not faster: the steps of a single double
    /// pendulum take 0.96 of the time with it, those of sixteen side by side 1.02.
    pub fn beginning(&self) -> Option<StraightLine> {
        const FEWEST: usize = 4;
        const MOST_PLACES: usize = 1 << 20;
        let (program, terms) = (&self.plan.program, self.plan.order + 1);
        if self.plan.lanes > 1 || program.arithmetic.len() < FEWEST || program.rows * terms > MOST_PLACES {
            return None;
        }
        let mut recording = Recording::new(program.rows, terms);
        for zeroth in &program.arithmetic {
            let (out, value) = match *zeroth {
                Zeroth::One { out, value } => (out, value.evaluate(&recording)?),
                Zeroth::Reciprocal { of, out } => {
                    let one = recording.recorder.push(Arithmetic::Number(1.0));
                    (out, recording.recorder.divide(&one, &recording.row(of)[0])?)
                }
                Zeroth::SineAndCosine { .. } => return None,
            };
            recording.keep(out, 0, value);
        }
        recording.line()
    }

    /// The computation of an expansion, given the zeroth coefficients; `None` if it depends on the values, or is too long for machine code.
    pub fn straight_line(&self) -> Option<StraightLine> {
        /// Largest number of instructions times half the square of the number of terms. Springs in a row: code for 0.2 million (64 masses at
        /// order 33) takes a quarter of the interpreter's time, for 0.7 and 0.8 million (256; 720 at order 20) a fifth to a half; before inner
        /// products were packed it took 0.7 for 1.2 million (400 at order 33) and 5.4 for 2.1 million.
        const MOST: usize = 1 << 20;
        let terms = self.plan.order + 1;
        if self.plan.program.instructions(1).count().saturating_mul(terms * terms / 2) > MOST {
            return None;
        }
        let mut recording = Recording::new(self.plan.program.rows, terms);
        let unit = recording.recorder.push(Arithmetic::Argument(0));
        for n in 1..=self.plan.order {
            for (of, out) in self.rates() {
                let value = rate(&recording, of, &unit, n)?;
                recording.keep(out, n, value);
            }
            if n <= self.last() {
                for instruction in self.plan.program.instructions(n) {
                    let (out, value) = instruction.evaluate(&recording, n)?;
                    recording.keep(out, n, value);
                }
            }
        }
        recording.line()
    }
}

/// A recorder of operations on numbers that are not known yet.
#[derive(Debug, Default)]
struct Recorder {
    steps: RefCell<Vec<Arithmetic>>,
    /// The slot of each step's value, if it is stored in one.
    places: RefCell<Vec<Option<usize>>>,
    /// Quotients by integers, each of which is computed once.
    quotients: RefCell<HashMap<(Recorded, u64), Recorded>>,
}

/// The number of a step.
type Recorded = usize;

impl Recorder {
    fn push(&self, step: Arithmetic) -> Recorded {
        let mut steps = self.steps.borrow_mut();
        steps.push(step);
        self.places.borrow_mut().push(None);
        steps.len() - 1
    }

    /// The initial value of a slot.
    fn initial(&self, slot: usize) -> Recorded {
        let value = self.push(Arithmetic::Place(slot));
        self.places.borrow_mut()[value] = Some(slot);
        value
    }

    fn keep(&self, value: Recorded, slot: usize) {
        self.push(Arithmetic::Keep { value, slot });
        self.places.borrow_mut()[value] = Some(slot);
    }

    /// The first slot of values in consecutive slots; `None` if they are not consecutive.
    fn first_place(&self, values: &[Recorded]) -> Option<usize> {
        let slots = self.places.borrow();
        let first = slots[*values.first()?]?;
        let behind = (first..).zip(values).all(|(slot, value)| slots[*value] == Some(slot));
        behind.then_some(first)
    }
}

impl MultiplyAdd for Recorder {
    type Element = Recorded;

    fn nothing(&self) -> Recorded {
        self.zero()
    }

    fn sum(&self, a: Recorded, b: Recorded) -> Recorded {
        self.add(&a, &b)
    }

    fn product(&self, a: Recorded, b: Recorded) -> Recorded {
        self.multiply(&a, &b)
    }

    fn multiply_add(&self, a: Recorded, b: Recorded, c: Recorded) -> Recorded {
        self.push(Arithmetic::MultiplyAdd(a, b, c))
    }
}

impl Ring for Recorder {
    type Element = Recorded;

    fn zero(&self) -> Recorded {
        self.push(Arithmetic::Number(0.0))
    }

    /// Returns `false`: no recorded value is known to be zero.
    fn is_zero(&self, _: &Recorded) -> bool {
        false
    }

    fn rational(&self, value: &Rational) -> Option<Recorded> {
        Some(self.push(Arithmetic::Number(value.to_f64())))
    }

    fn add(&self, a: &Recorded, b: &Recorded) -> Recorded {
        self.push(Arithmetic::Add(*a, *b))
    }

    fn subtract(&self, a: &Recorded, b: &Recorded) -> Recorded {
        self.push(Arithmetic::Subtract(*a, *b))
    }

    fn negate(&self, a: &Recorded) -> Recorded {
        self.push(Arithmetic::Negate(*a))
    }

    fn multiply(&self, a: &Recorded, b: &Recorded) -> Recorded {
        self.push(Arithmetic::Multiply(*a, *b))
    }

    #[expect(clippy::cast_precision_loss, reason = "as in lanes")]
    fn times_integer(&self, a: &Recorded, factor: i64) -> Recorded {
        let factor = self.push(Arithmetic::Number(factor as f64));
        self.multiply(a, &factor)
    }

    fn divide(&self, a: &Recorded, divisor: &Recorded) -> Option<Recorded> {
        Some(self.push(Arithmetic::Divide(*a, *divisor)))
    }

    #[expect(clippy::cast_precision_loss, reason = "as in lanes")]
    fn over_integer(&self, a: &Recorded, divisor: u64) -> Option<Recorded> {
        let form = || match prepared_reciprocal(divisor) {
            Some(reciprocal) => self.multiply(a, &self.push(Arithmetic::Number(reciprocal))),
            None => self.push(Arithmetic::Divide(*a, self.push(Arithmetic::Number(divisor as f64)))),
        };
        Some(*self.quotients.borrow_mut().entry((*a, divisor)).or_insert_with(form))
    }

    fn value(&self, _: Function, _: &Recorded) -> Option<Recorded> {
        None
    }

    fn power(&self, _: &Recorded, _: &Rational) -> Option<Recorded> {
        None
    }

    fn pi(&self) -> Option<Recorded> {
        Some(self.push(Arithmetic::Number(std::f64::consts::PI)))
    }

    fn convolution(&self, a: &[Recorded], b: &[Recorded]) -> Recorded {
        convolution(self, a, b)
    }
}

impl Rounded<Recorded> for Recorder {
    fn inner_product(&self, a: &[Recorded], b: &[Recorded]) -> Recorded {
        match (self.first_place(a), self.first_place(b)) {
            (Some(first), Some(other)) => {
                self.push(Arithmetic::InnerProduct { a: first, b: other, count: a.len() })
            }
            _ if a.is_empty() => self.nothing(),
            _ => inner_product(self, a, b),
        }
    }
}

/// A block whose values are not known yet.
#[derive(Debug)]
struct Recording {
    recorder: Recorder,
    /// The values of all coefficients.
    values: Vec<Recorded>,
    terms: usize,
}

impl Recording {
    fn new(rows: usize, terms: usize) -> Self {
        let recorder = Recorder::default();
        let values = (0..rows * terms).map(|slot| recorder.initial(slot)).collect();
        Self { recorder, values, terms }
    }

    /// The recorded operations; the argument of the code is the unit of time.
    fn line(self) -> Option<StraightLine> {
        StraightLine::new(self.recorder.steps.into_inner(), self.values.len(), 1).ok()
    }

    fn keep(&mut self, row: Row, n: usize, value: Recorded) {
        let slot = row.first() + n;
        self.recorder.keep(value, slot);
        self.values[slot] = value;
    }
}

impl Evaluator<Row, f64> for Recording {
    type Ring = Recorder;

    fn ring(&self) -> &Recorder {
        &self.recorder
    }

    fn row(&self, row: Row) -> &[Recorded] {
        &self.values[row.first()..row.first() + self.terms]
    }

    fn exponent(&self, exponent: &f64) -> Option<Recorded> {
        Some(self.recorder.push(Arithmetic::Number(*exponent)))
    }

    fn power(&self, _: &Recorded, _: &f64) -> Option<Recorded> {
        None
    }

    fn square(&self, a: &[Recorded]) -> Recorded {
        square(&self.recorder, a)
    }

    fn quotient(&self, a_n: &Recorded, c: &[Recorded], b: &[Recorded]) -> Option<Recorded> {
        quotient(&self.recorder, *a_n, c, b)
    }

    fn integral(&self, a_n: &Recorded, weighted_a: &[Recorded], b: &[Recorded]) -> Option<Recorded> {
        integral(&self.recorder, *a_n, weighted_a, b)
    }

    fn begins_beyond(&self, exponent: &f64, n: usize) -> bool {
        begins_beyond(*exponent, n)
    }

    /// The quotient; `None` if a power may begin at a later order, since it then depends on whether its base is zero.
    fn over_base(&self, value: &Recorded, base: &Recorded, begins_later: bool) -> Option<Recorded> {
        if begins_later { None } else { self.recorder.divide(value, base) }
    }
}
