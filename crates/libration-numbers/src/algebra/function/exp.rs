//! eˣ.

use super::entry::{Entry, Growth, Rule, at_zero};

pub(super) const ENTRY: Entry = Entry {
    name: "exp",
    word: "exp",
    latex: ["\\mathrm{e}^{", "}"],
    parity: None,
    growth: Growth::Exponential,
    has_zeros: false,
    domain: None,
    rule: Rule::Itself,
    double: libm::exp,
    float: |x, _| Some(x.exp()),
    rational: |x| at_zero(x, 1),
};
