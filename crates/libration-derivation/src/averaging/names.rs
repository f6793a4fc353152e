//! The names of coefficients by the powers of the amplitude and of the small parameter, and sums of them as formulas.

use super::super::formula::{Formula, Name, Subscript, letter, scaled, sum};
use super::super::phase::{PiNumber, term_with};
use super::flow::PowerPair;
use super::question::AveragingQuestion;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::internals::InOrder;
use std::collections::BTreeMap;

/// A symbol with the two powers as subscript.
pub(super) fn indexed(name: Name, (n, j): PowerPair) -> Name {
    match n {
        // A number would lose its leading zero.
        0 => Name { subscript: Some(Subscript::Word(format!("0{j}"))), ..name },
        _ => name.index(i64::try_from(10 * n + j).unwrap_or(i64::MAX)),
    }
}

/// xₙⱼ.
pub(super) fn motion_name(question: &AveragingQuestion, powers: PowerPair) -> Name {
    indexed(question.displacement.clone(), powers)
}

pub(super) fn velocity_name(powers: PowerPair) -> Name {
    indexed(Name::new("v"), powers)
}

/// aₙⱼ.
pub(super) fn growth_name(powers: PowerPair) -> Name {
    indexed(Name::new("a"), powers)
}

/// wₙⱼ.
pub(super) fn frequency_name(powers: PowerPair) -> Name {
    indexed(Name::new("w"), powers)
}

/// Products of coefficients as a formula.
pub(super) fn of_products(question: &AveragingQuestion, products: &Polynomial) -> Formula {
    let terms = products.terms().map(|(monomial, factor)| {
        let factors = monomial.factors().iter().map(|(variable, exponent)| {
            let base = Formula::from(of_variable(question, variable));
            if *exponent == 1 { base } else { base.pow(i64::from(*exponent)) }
        });
        match factors.reduce(|product, factor| product * factor) {
            None => Formula::Number(factor.clone()),
            Some(product) => scaled(factor, product),
        }
    });
    sum(terms.collect())
}

fn of_variable(question: &AveragingQuestion, variable: &Variable) -> Name {
    let index = usize::try_from(variable.index().unwrap_or(0)).unwrap_or(usize::MAX);
    let primes = variable.letters().chars().filter(|letter| *letter == '\'').count();
    let name = match variable.letters().trim_end_matches('\'') {
        "x" => question.displacement.clone(),
        other => Name::new(other),
    };
    let name = indexed(name, (index / 10, index % 10));
    (0..primes).fold(name, |name, _| name.prime())
}

/// Aⁿcʲ.
pub(super) fn powers(question: &AveragingQuestion, (n, j): PowerPair) -> Vec<Formula> {
    let power = |base: Formula, n: usize| match n {
        0 => None,
        1 => Some(base),
        n => Some(base.pow(i64::try_from(n).unwrap_or(i64::MAX))),
    };
    power(question.small(), j).into_iter().chain(power(question.amplitude(), n)).collect()
}

/// Aⁿcʲ as one formula.
pub(super) fn power(question: &AveragingQuestion, pair: PowerPair) -> Formula {
    let factors = powers(question, pair);
    factors.into_iter().reduce(|product, factor| product * factor).unwrap_or_else(|| Formula::from(1))
}

/// Σ coefficient·Aⁿcʲ, lower powers of the small parameter first.
pub(super) fn law(question: &AveragingQuestion, coefficients: &BTreeMap<PowerPair, PiNumber>) -> Formula {
    let mut pairs: Vec<&PowerPair> = coefficients.keys().filter(|pair| question.asks_for(**pair)).collect();
    pairs.put_in_order_by(|(n, j)| (*j, *n));
    let terms = pairs.into_iter().flat_map(|pair| {
        let value = coefficients.get(pair).into_iter().flat_map(PiNumber::terms);
        value.map(|(pi, coefficient)| term_with(coefficient, pi, powers(question, *pair))).collect::<Vec<_>>()
    });
    let terms: Vec<Formula> = terms.collect();
    if terms.is_empty() { Formula::from(0) } else { sum(terms) }
}

/// A factor ω0ⁿ, left out if ω0 is one.
pub(super) fn times_omega0(question: &AveragingQuestion, exponent: isize, formula: Formula) -> Formula {
    let factor = question.omega0().integer_power(exponent).unwrap_or_else(|| Rational::from(1));
    scaled(&factor, formula)
}

/// A symbol with several symbols as subscript, as in aₙⱼ.
pub(super) fn below(name: Name, letters: &[&str]) -> Name {
    let index = letters.iter().map(|subscript| letter(subscript)).reduce(|product, factor| product * factor);
    name.index(index.unwrap_or_else(|| Formula::from(0)))
}

/// ψ.
pub(super) fn phase() -> Formula {
    letter("ψ")
}
