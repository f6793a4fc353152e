//! arctan x.

use super::entry::{Divisor, Entry, Growth, Parity, Rule, Slope, at_zero};

pub(super) const ENTRY: Entry = Entry {
    name: "atan",
    word: "arctan",
    latex: ["\\arctan\\left(", "\\right)"],
    parity: Some(Parity::Odd),
    growth: Growth::Bounded,
    has_zeros: true,
    domain: None,
    rule: Rule::Inverse(Slope::Plus, Divisor::OneAndSquare),
    double: libm::atan,
    float: |x, _| Some(x.atan()),
    rational: |x| at_zero(x, 0),
};
