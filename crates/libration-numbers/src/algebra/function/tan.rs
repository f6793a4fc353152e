//! tan x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};
use crate::algebra::BigFloat;

pub(super) const ENTRY: Entry = Entry {
    name: "tan",
    word: "tan",
    latex: ["\\tan\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Bounded,
    has_zeros: true,
    domain: None,
    rule: Rule::Quotient(Pair::CIRCULAR),
    double: libm::tan,
    float: tangent,
    rational: |x| at_zero(x, 0),
};

fn tangent(x: &BigFloat, _: usize) -> Option<BigFloat> {
    let cosine = x.cos();
    (!cosine.is_zero()).then(|| x.sin() / cosine)
}
