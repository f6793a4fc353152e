//! |x|.

use super::entry::{Entry, Growth, Parity, Rule};
use crate::algebra::{BigFloat, Rational};

pub(super) const ENTRY: Entry = Entry {
    name: "abs",
    word: "abs",
    latex: ["\\left|", "\\right|"],
    parity: Some(Parity::Even),
    growth: Growth::Power,
    has_zeros: true,
    domain: None,
    rule: Rule::Modulus,
    double: f64::abs,
    float: magnitude,
    rational: |x| Some(Rational::magnitude(x)),
};

fn magnitude(x: &BigFloat, precision: usize) -> Option<BigFloat> {
    let positive = *x > BigFloat::from_integer(0, precision);
    Some(if positive { x.clone() } else { -x.clone() })
}
