//! Errors of final states against the reference digits, and the part that rounding errors along the motion explain.

use crate::golden::Row;
use crate::ulp::Truth;

/// The largest error of a state against the reference digits of its row.
pub fn error(state: &[f64], row: Row) -> f64 {
    let truths: Vec<Truth> = row.text("state").split(' ').map(Truth::from_decimal).collect();
    assert_eq!(state.len(), truths.len());
    let distance = |(got, truth): (&f64, &Truth)| ((got - truth.hi) - truth.lo).abs();
    state.iter().zip(&truths).map(distance).fold(0.0, f64::max)
}

/// Growth of a rounding error along the motion, over the consecutive rows of one case.
#[derive(Debug, Default)]
pub struct Growth {
    case: String,
    largest: f64,
}

impl Growth {
    /// Size of a rounding error up to this row. The largest growth so far counts, since an error inside the motion may shrink until the end.
    pub fn until(&mut self, case: &str, row: Row) -> f64 {
        let here = row.input("sensitivity");
        let largest = if self.case == case { self.largest.max(here) } else { here };
        *self = Self { case: case.to_owned(), largest };
        f64::EPSILON * (1.0 + row.input("size")) * (1.0 + largest)
    }
}
