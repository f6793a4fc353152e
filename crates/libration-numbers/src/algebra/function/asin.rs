//! arcsin x.

use super::entry::{BETWEEN_ONES, Divisor, Entry, Growth, Parity, Rule, Slope, at_zero, is_between_ones};

pub(super) const ENTRY: Entry = Entry {
    name: "asin",
    word: "arcsin",
    latex: ["\\arcsin\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Bounded,
    has_zeros: true,
    domain: Some(BETWEEN_ONES),
    rule: Rule::Inverse(Slope::Plus, Divisor::RootOfOneLessSquare),
    double: libm::asin,
    float: |x, precision| is_between_ones(x, precision).then(|| x.asin()),
    rational: |x| at_zero(x, 0),
};
