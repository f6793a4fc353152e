//! √x.

use super::entry::{Domain, Entry, Growth, Rule};
use crate::algebra::{BigFloat, Rational};

pub(super) const ENTRY: Entry = Entry {
    name: "sqrt",
    word: "sqrt",
    latex: ["\\sqrt{", "}"],
    parity: None,
    growth: Growth::Power,
    has_zeros: true,
    domain: Some(Domain { low: Some(0), high: None, why: "the root of a negative number is not real" }),
    rule: Rule::Root,
    double: f64::sqrt,
    float: |x, precision| (*x >= BigFloat::from_integer(0, precision)).then(|| x.sqrt()),
    rational: Rational::square_root,
};
