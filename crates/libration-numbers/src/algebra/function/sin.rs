//! sin x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};

pub(super) const ENTRY: Entry = Entry {
    name: "sin",
    word: "sin",
    latex: ["\\sin\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Bounded,
    has_zeros: true,
    domain: None,
    rule: Rule::Paired(Pair::CIRCULAR),
    double: libm::sin,
    float: |x, _| Some(x.sin()),
    rational: |x| at_zero(x, 0),
};
