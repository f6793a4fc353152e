//! cos x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};

pub(super) const ENTRY: Entry = Entry {
    name: "cos",
    word: "cos",
    latex: ["\\cos\\left(", "\\right)"],
    parity: Some(Parity::Even),
    growth: Growth::Bounded,
    has_zeros: true,
    domain: None,
    rule: Rule::Paired(Pair::CIRCULAR),
    double: libm::cos,
    float: |x, _| Some(x.cos()),
    rational: |x| at_zero(x, 1),
};
