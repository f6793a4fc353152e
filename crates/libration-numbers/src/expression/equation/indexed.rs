//! Equations for each number of a range: `x[i]'' = k*(x[i+1] - 2*x[i] + x[i-1]), i = 1..32`.
//!
//! A member with an index outside all ranges is zero, or has the value that an equation such as `x[0] = A*cos(t)` or `x[33] = x[1]` states.
//!
//! # Method
//! Until all equations are read, `x[i]` is a symbol with that name. Each range is then expanded: indices become numbers, members get plain names
//! (x3), and members without an equation are zero or have their stated values. A name x0 next to `x[i]` is rejected if `x[0]` lies outside the
//! range.

use std::collections::{BTreeMap, BTreeSet};

use super::{EquationError, Expression, Sides, Symbol, TIME};
use crate::expression::lexer::IndexRange;
use crate::expression::members::{Member, member_name, with_names};
use crate::quantity::excerpt;

/// Maximum number of equations that ranges may expand to: the state of such a system and its series take some megabytes.
const MOST_EQUATIONS: usize = 1000;

/// An equation as written, with the range of its index.
pub(super) struct Written {
    pub(super) sides: Sides,
    pub(super) range: Option<IndexRange>,
}

/// One equation for each number of each range, with plain names.
pub(super) fn expanded(written: Vec<Written>) -> Result<Vec<Sides>, EquationError> {
    let is_plain =
        |one: &Written| one.range.is_none() && !symbols(&one.sides).any(|symbol| symbol.name.contains('['));
    if written.iter().all(is_plain) {
        return Ok(written.into_iter().map(|one| one.sides).collect());
    }
    let sizes = written.iter().filter_map(|one| one.range.as_ref());
    if sizes.map(|size| size.last.saturating_sub(size.first) as usize + 1).sum::<usize>() > MOST_EQUATIONS {
        return Err(EquationError::TooManyEquations { limit: MOST_EQUATIONS });
    }
    let mut equations = vec![];
    for one in written {
        equations.extend(one.equations()?);
    }
    Chain::of(equations)?.plain()
}

fn symbols((left, right): &Sides) -> impl Iterator<Item = Symbol> {
    left.symbols().into_iter().chain(right.symbols())
}

impl Written {
    /// The equations for every number in the range, with numbers as indices.
    fn equations(self) -> Result<Vec<Sides>, EquationError> {
        let Some(IndexRange { letter, first, last }) = self.range else {
            return Ok(vec![at(&self.sides, None)?]);
        };
        if first > last {
            return Err(EquationError::EmptyRange { letter, first, last });
        }
        (first..=last).map(|number| at(&self.sides, Some((&letter, number)))).collect()
    }
}

/// The equation for one value of the index.
fn at((left, right): &Sides, index: Option<(&str, u32)>) -> Result<Sides, EquationError> {
    let mut names = BTreeMap::new();
    for symbol in symbols(&(left.clone(), right.clone())) {
        if let Some(member) = Member::of(&symbol.name) {
            let number = number_of(&member, index)?;
            names.insert(symbol.name.clone(), format!("{}[{number}]", member.family));
        }
    }
    let side = |side: &Expression| {
        let named = with_names(side, &|name| names.get(name).cloned());
        match index {
            Some((letter, number)) => {
                named.with_value(&Symbol::plain(letter), &Expression::from(i64::from(number)))
            }
            None => named,
        }
    };
    Ok((side(left), side(right)))
}

/// The index as a number.
fn number_of(member: &Member<'_>, index: Option<(&str, u32)>) -> Result<i64, EquationError> {
    let name = || format!("{}[{}]", member.family, member.index);
    let formula: Expression = member.index.parse()?;
    let formula = match index {
        Some((letter, number)) => {
            formula.with_value(&Symbol::plain(letter), &Expression::from(i64::from(number)))
        }
        None => formula,
    };
    if let Some(letter) = formula.symbols().pop_first() {
        return Err(EquationError::IndexWithoutRange { name: name(), letter });
    }
    let whole = formula
        .to_rational()
        .filter(|rational| rational.is_integer())
        .and_then(|rational| rational.to_string().parse().ok());
    whole.ok_or_else(|| EquationError::IndexNotWhole {
        name: name(),
        value: formula.to_string(),
        place: index.map_or_else(String::new, |(letter, number)| format!(" at {letter} = {number}")),
    })
}

/// Equations between members, and the stated values of members outside the ranges.
struct Chain {
    equations: Vec<Sides>,
    /// Members that have an equation of motion.
    inside: BTreeSet<String>,
    families: BTreeSet<String>,
    ends: BTreeMap<String, Expression>,
}

impl Chain {
    fn of(equations: Vec<Sides>) -> Result<Self, EquationError> {
        let inside = own_members(&equations);
        let families = inside.iter().filter_map(|name| Some(Member::of(name)?.family.to_owned()));
        let mut chain =
            Self { families: families.collect(), inside, equations: vec![], ends: BTreeMap::new() };
        for sides in equations {
            match chain.end_told_by(&sides) {
                Some(name) if chain.inside.contains(&name) => {
                    let (left, right) = &sides;
                    return Err(EquationError::ValueOfVariable {
                        equation: excerpt(&format!("{left} = {right}")),
                        name,
                    });
                }
                Some(name) if chain.ends.contains_key(&name) => return Err(EquationError::SetTwice(name)),
                Some(name) => drop(chain.ends.insert(name, sides.1)),
                None => chain.equations.push(sides),
            }
        }
        Ok(chain)
    }

    /// The member whose value an equation such as `x[0] = 0` states.
    fn end_told_by(&self, sides: &Sides) -> Option<String> {
        let Expression::Symbol(Symbol { name, primes: 0 }) = &sides.0 else { return None };
        let is_member = self.families.contains(Member::of(name)?.family);
        (is_member && sides.1.symbols().iter().all(|symbol| symbol.primes == 0)).then(|| name.clone())
    }

    fn plain(&self) -> Result<Vec<Sides>, EquationError> {
        let side = |side: &Expression| self.with_ends(side).and_then(|side| plain_names(&side));
        self.equations.iter().map(|(left, right)| Ok((side(left)?, side(right)?))).collect()
    }

    /// A formula in which members outside the ranges are replaced by their stated values, or zero.
    fn with_ends(&self, formula: &Expression) -> Result<Expression, EquationError> {
        let mut replaced = formula.clone();
        for symbol in formula.symbols() {
            match Member::of(&symbol.name) {
                Some(member) if self.families.contains(member.family) => {
                    if !self.inside.contains(&symbol.name) {
                        replaced = replaced.with_value(&symbol, &self.end(&symbol)?);
                    }
                }
                Some(_) => {}
                None => self.refuse_end_without_brackets(&symbol)?,
            }
        }
        Ok(replaced)
    }

    /// The expression for a member outside the ranges, or for its velocity.
    fn end(&self, symbol: &Symbol) -> Result<Expression, EquationError> {
        let Some(end) = self.ends.get(&symbol.name) else { return Ok(Expression::from(0)) };
        if let Expression::Symbol(other) = end
            && self.inside.contains(&other.name)
        {
            return Ok(Expression::Symbol(other.with_primes(symbol.primes)));
        }
        if let Some(other) = end
            .symbols()
            .into_iter()
            .find(|symbol| symbol.name.contains('[') && !self.inside.contains(&symbol.name))
        {
            return Err(EquationError::EndByEnd { name: symbol.name.clone(), other: other.name });
        }
        let moves = end.symbols().iter().any(|symbol| self.inside.contains(&symbol.name));
        if symbol.primes > 0 && moves {
            return Err(EquationError::RateOfEnd { rate: symbol.clone(), end: excerpt(&end.to_string()) });
        }
        let time = Symbol::plain(TIME);
        let rate = |formula: Expression, _| formula.derivative(&time);
        Ok((0..symbol.primes).fold(end.clone(), rate).simplified())
    }

    /// Rejects x0 if `x[0]` lies outside the ranges.
    fn refuse_end_without_brackets(&self, symbol: &Symbol) -> Result<(), EquationError> {
        let digits = symbol.name.trim_start_matches(|c: char| !c.is_ascii_digit());
        let Ok(number) = digits.parse::<u32>() else { return Ok(()) };
        let family = &symbol.name[..symbol.name.len() - digits.len()];
        let indexed = format!("{family}[{number}]");
        let is_outside = self.families.contains(family)
            && member_name(family, number.into()) == symbol.name
            && !self.inside.contains(&indexed);
        match is_outside {
            true => Err(EquationError::AmbiguousMember { name: symbol.name.clone(), indexed }),
            false => Ok(()),
        }
    }
}

/// The members that have an equation: those with a second derivative, and in equations without one those with a first derivative.
fn own_members(equations: &[Sides]) -> BTreeSet<String> {
    let members = |sides: &Sides, primes: u8| -> BTreeSet<String> {
        let members =
            symbols(sides).filter(|symbol| symbol.primes == primes && Member::of(&symbol.name).is_some());
        members.map(|symbol| symbol.name).collect()
    };
    let accelerated: BTreeSet<String> = equations.iter().flat_map(|sides| members(sides, 2)).collect();
    let families: BTreeSet<&str> =
        accelerated.iter().filter_map(|name| Some(Member::of(name)?.family)).collect();
    let slow = equations.iter().filter(|sides| symbols(sides).all(|symbol| symbol.primes < 2));
    let rates = slow.flat_map(|sides| members(sides, 1));
    let slow_members =
        rates.filter(|name| Member::of(name).is_some_and(|member| !families.contains(member.family)));
    slow_members.chain(accelerated.iter().cloned()).collect()
}

/// The formula with x3 in place of `x[3]`; `x[-1]` has no such name.
fn plain_names(formula: &Expression) -> Result<Expression, EquationError> {
    let below = formula.symbols().into_iter().find(|symbol| symbol.name.contains("[-"));
    if let Some(Symbol { name, .. }) = below {
        return Err(EquationError::NegativeIndex(name));
    }
    Ok(with_names(formula, &|name| {
        let member = Member::of(name)?;
        Some(member_name(member.family, member.index.parse().ok()?))
    }))
}
