//! tanh x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};
use super::hyperbolic::sinh_cosh;
use crate::algebra::BigFloat;

pub(super) const ENTRY: Entry = Entry {
    name: "tanh",
    word: "tanh",
    latex: ["\\tanh\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Hyperbolic,
    has_zeros: true,
    domain: None,
    rule: Rule::Quotient(Pair::HYPERBOLIC),
    double: libm::tanh,
    float: tangent,
    rational: |x| at_zero(x, 0),
};

fn tangent(x: &BigFloat, precision: usize) -> Option<BigFloat> {
    let [sine, cosine] = sinh_cosh(x, precision);
    Some(sine / cosine)
}
