//! Interpretation of a line, one step after the other and one lane after the other.

use crate::inner_product::Numbers;
use crate::{Arithmetic, StraightLine, inner_product};

impl StraightLine {
    /// Runs the line in `lanes` lanes; the numbers of the lanes are side by side in each slot and in each argument.
    ///
    /// # Panics
    /// If there are fewer numbers than slots or arguments times lanes.
    pub fn interpret(&self, places: &mut [f64], arguments: &[f64], lanes: usize) {
        let mut values = vec![0.0; self.steps().len()];
        for lane in 0..lanes {
            for (number, step) in self.steps().iter().enumerate() {
                values[number] = match *step {
                    Arithmetic::Place(slot) => places[slot * lanes + lane],
                    Arithmetic::Argument(argument) => arguments[argument * lanes + lane],
                    Arithmetic::Number(number) => number,
                    Arithmetic::Negate(a) => -values[a],
                    Arithmetic::Add(a, b) => values[a] + values[b],
                    Arithmetic::Subtract(a, b) => values[a] - values[b],
                    Arithmetic::Multiply(a, b) => values[a] * values[b],
                    Arithmetic::Divide(a, b) => values[a] / values[b],
                    Arithmetic::MultiplyAdd(a, b, c) => values[a].mul_add(values[b], values[c]),
                    Arithmetic::InnerProduct { a, b, count } => {
                        let at = |first: usize| -> Vec<f64> {
                            (first..first + count).map(|slot| places[slot * lanes + lane]).collect()
                        };
                        inner_product(&Numbers, &at(a), &at(b))
                    }
                    Arithmetic::Keep { value, slot } => {
                        places[slot * lanes + lane] = values[value];
                        0.0
                    }
                };
            }
        }
    }
}
