//! Members of families of variables or parameters: `x[3]` has the name x3 in output and in requests.

use super::{Expression, Symbol};

/// A name with its index: `x[i+1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Member<'a> {
    pub(super) family: &'a str,
    pub(super) index: &'a str,
}

impl<'a> Member<'a> {
    /// The member whose name a symbol has; `None` for names without an index.
    pub(super) fn of(name: &'a str) -> Option<Self> {
        let (family, index) = name.strip_suffix(']')?.split_once('[')?;
        Some(Self { family, index })
    }
}

/// Name of the member with this number: x3, or `w1_3` if the name of the family ends with a digit.
pub(super) fn member_name(family: &str, number: i64) -> String {
    let between = if family.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { "" };
    format!("{family}{between}{number}")
}

/// A formula in which members with a number as index have their plain names.
pub(super) fn members_named(formula: &Expression) -> Expression {
    with_names(formula, &|name| {
        let member = Member::of(name)?;
        Some(member_name(member.family, member.index.parse::<u32>().ok()?.into()))
    })
}

/// A formula with some of its symbols renamed.
pub(super) fn with_names(formula: &Expression, other: &impl Fn(&str) -> Option<String>) -> Expression {
    match formula {
        Expression::Symbol(symbol) => match other(&symbol.name) {
            Some(name) => Expression::Symbol(Symbol { name, primes: symbol.primes }),
            None => formula.clone(),
        },
        _ => formula.with_parts(|part| with_names(part, other)),
    }
}
