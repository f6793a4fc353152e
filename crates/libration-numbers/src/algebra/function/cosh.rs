//! cosh x.

use super::entry::{Entry, Growth, Pair, Parity, Rule, at_zero};
use super::hyperbolic::cosh;

pub(super) const ENTRY: Entry = Entry {
    name: "cosh",
    word: "cosh",
    latex: ["\\cosh\\left(", "\\right)"],
    parity: Some(Parity::Even),
    growth: Growth::Hyperbolic,
    has_zeros: false,
    domain: None,
    rule: Rule::Paired(Pair::HYPERBOLIC),
    double: libm::cosh,
    float: |x, precision| Some(cosh(x, precision)),
    rational: |x| at_zero(x, 1),
};
