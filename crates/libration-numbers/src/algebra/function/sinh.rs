//! sinh x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};
use super::hyperbolic::sinh;

pub(super) const ENTRY: Entry = Entry {
    name: "sinh",
    word: "sinh",
    latex: ["\\sinh\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Hyperbolic,
    has_zeros: true,
    domain: None,
    rule: Rule::Paired(Pair::HYPERBOLIC),
    double: libm::sinh,
    float: |x, precision| Some(sinh(x, precision)),
    rational: |x| at_zero(x, 0),
};
