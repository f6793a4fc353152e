//! ln x.

use super::entry::{Divisor, Domain, Entry, Growth, Rule, Slope, zero_at_one};
use crate::algebra::BigFloat;

pub(super) const ENTRY: Entry = Entry {
    name: "ln",
    word: "ln",
    latex: ["\\ln\\left(", "\\right)"],
    parity: None,
    growth: Growth::Power,
    has_zeros: true,
    domain: Some(Domain { low: Some(0), high: None, why: "the logarithm is for numbers above zero" }),
    rule: Rule::Inverse(Slope::Plus, Divisor::Argument),
    double: libm::log,
    float: |x, precision| (*x > BigFloat::from_integer(0, precision)).then(|| x.ln()),
    rational: zero_at_one,
};
