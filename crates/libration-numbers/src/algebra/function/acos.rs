//! arccos x.

use super::entry::{BETWEEN_ONES, Divisor, Entry, Growth, Rule, Slope, is_between_ones, zero_at_one};

pub(super) const ENTRY: Entry = Entry {
    name: "acos",
    word: "arccos",
    latex: ["\\arccos\\left(", "\\right)"],
    parity: None,
    growth: Growth::Bounded,
    has_zeros: true,
    domain: Some(BETWEEN_ONES),
    rule: Rule::Inverse(Slope::Minus, Divisor::RootOfOneLessSquare),
    double: libm::acos,
    float: |x, precision| is_between_ones(x, precision).then(|| x.acos()),
    rational: zero_at_one,
};
