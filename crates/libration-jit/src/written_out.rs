//! Inner products as single additions and multiplications.

use std::cell::RefCell;

use crate::{Arithmetic, MultiplyAdd, OutOfOrder, StraightLine, inner_product};

/// The same line with every inner product as single steps, for registers whose lanes are all in use already.
pub(crate) fn written_out(line: &StraightLine) -> Result<StraightLine, OutOfOrder> {
    let steps = Steps::default();
    let mut numbers = Vec::with_capacity(line.steps().len());
    let mut at: Vec<Option<usize>> = vec![None; line.places()];
    for step in line.steps() {
        let new = match *step {
            Arithmetic::InnerProduct { a, b, count } => {
                let mut values = |first: usize| -> Vec<usize> {
                    let value =
                        |slot: usize| *at[slot].get_or_insert_with(|| steps.push(Arithmetic::Place(slot)));
                    (first..first + count).map(value).collect()
                };
                inner_product(&steps, &values(a), &values(b))
            }
            other => steps.push(with_operands(other, |operand| numbers[operand])),
        };
        if let Arithmetic::Keep { value, slot } = *step {
            at[slot] = Some(numbers[value]);
        }
        numbers.push(new);
    }
    StraightLine::new(steps.0.into_inner(), line.places(), line.arguments())
}

/// The same step with other operands.
fn with_operands(step: Arithmetic, other: impl Fn(usize) -> usize) -> Arithmetic {
    match step {
        Arithmetic::Place(_)
        | Arithmetic::Argument(_)
        | Arithmetic::Number(_)
        | Arithmetic::InnerProduct { .. } => step,
        Arithmetic::Negate(a) => Arithmetic::Negate(other(a)),
        Arithmetic::Add(a, b) => Arithmetic::Add(other(a), other(b)),
        Arithmetic::Subtract(a, b) => Arithmetic::Subtract(other(a), other(b)),
        Arithmetic::Multiply(a, b) => Arithmetic::Multiply(other(a), other(b)),
        Arithmetic::Divide(a, b) => Arithmetic::Divide(other(a), other(b)),
        Arithmetic::MultiplyAdd(a, b, c) => Arithmetic::MultiplyAdd(other(a), other(b), other(c)),
        Arithmetic::Keep { value, slot } => Arithmetic::Keep { value: other(value), slot },
    }
}

/// The steps of one inner product, and the number of the step with its value. The slots of the first row are numbered first, then those of the
/// second.
pub(crate) fn inner_product_steps(count: usize) -> (Vec<Arithmetic>, usize) {
    let steps = Steps::default();
    let row = |first: usize| -> Vec<usize> {
        (first..first + count).map(|slot| steps.push(Arithmetic::Place(slot))).collect()
    };
    let [a, b] = [row(0), row(count)];
    let result = inner_product(&steps, &a, &b);
    (steps.0.into_inner(), result)
}

/// Steps that are written one after the other.
#[derive(Debug, Default)]
struct Steps(RefCell<Vec<Arithmetic>>);

impl Steps {
    fn push(&self, step: Arithmetic) -> usize {
        let mut steps = self.0.borrow_mut();
        steps.push(step);
        steps.len() - 1
    }
}

impl MultiplyAdd for Steps {
    type Element = usize;

    fn nothing(&self) -> usize {
        self.push(Arithmetic::Number(0.0))
    }

    fn sum(&self, a: usize, b: usize) -> usize {
        self.push(Arithmetic::Add(a, b))
    }

    fn product(&self, a: usize, b: usize) -> usize {
        self.push(Arithmetic::Multiply(a, b))
    }

    fn multiply_add(&self, a: usize, b: usize, c: usize) -> usize {
        self.push(Arithmetic::MultiplyAdd(a, b, c))
    }
}
