//! Members of families of variables or parameters: `x[3]` is written back, and requested, as x3.

use super::{Expression, Symbol};

/// A name with its index: `x[i+1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Member<'a> {
    pub(super) family: &'a str,
    pub(super) index: &'a str,
}

impl<'a> Member<'a> {
    /// Member with the name of a symbol; `None` for names without an index.
    pub(super) fn of(name: &'a str) -> Option<Self> {
        let (family, index) = name.strip_suffix(']')?.split_once('[')?;
        Some(Self { family, index })
    }
}

/// Name of the member of this number: x3, and `w1_3` where the family's own name ends with a digit.
pub(super) fn member_name(family: &str, number: i64) -> String {
    let between = if family.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { "" };
    format!("{family}{between}{number}")
}

/// A formula with the names of members whose index is a number.
pub(super) fn members_named(formula: &Expression) -> Expression {
    with_names(formula, &|name| {
        let member = Member::of(name)?;
        Some(member_name(member.family, member.index.parse::<u32>().ok()?.into()))
    })
}

/// A formula with other names for some of its symbols.
pub(super) fn with_names(formula: &Expression, other: &impl Fn(&str) -> Option<String>) -> Expression {
    match formula {
        Expression::Symbol(symbol) => match other(&symbol.name) {
            Some(name) => Expression::Symbol(Symbol { name, primes: symbol.primes }),
            None => formula.clone(),
        },
        _ => formula.with_parts(|part| with_names(part, other)),
    }
}
