//! Origins of the terms of a condition: the parts of the equation of motion, before the results of lower orders are inserted.

use super::super::document::{Cells, DerivationTable};
use super::super::formula::{Formula, letter, sum};
use super::super::prose::Prose;
use super::names::{coefficient_name, cosine};
use super::products::{self, Factors, Products};
use super::question::LindstedtQuestion;
use super::reduced::term_formula;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::{Condition, RestoringTerm};
use std::collections::BTreeMap;

/// The symbol of the corrections of the frequency.
const FREQUENCY: &str = "d";

/// Parts of the equation of motion with their contributions to the conditions; vanishing coefficients are omitted.
#[derive(Debug)]
pub struct Contributions {
    /// Each part with its factors, by the power of ε and the harmonic.
    pub parts: Vec<(Formula, Factors)>,
    /// The term of each part; `None` for the linear part.
    powers: Vec<Option<RestoringTerm>>,
    displacement: Factors,
    ratio: Factors,
    squared_ratio: Factors,
}

impl Contributions {
    /// Computes the contribution of each part of the equation of motion.
    pub fn new(question: &LindstedtQuestion) -> Self {
        let displacement = displacement(question);
        let ratio = ratio(question);
        let squared_ratio = product(&ratio, &ratio, question.order);
        let mut parts = vec![(linear_part(question), linear(question, &displacement, &squared_ratio))];
        let mut powers = vec![None];
        let velocity = velocity(question, &displacement);
        let mut of_both = BTreeMap::new();
        for term in question.terms() {
            let exponents = [term.position, term.velocity];
            let power = power(&mut of_both, [&displacement, &velocity], exponents, question.order);
            let mut factors = Factors::new();
            for (key, value) in power {
                factors.insert(key, value * term.factor.clone());
            }
            parts.push((term_formula(term, &question.displacement), factors));
            powers.push(Some(term.clone()));
        }
        Self { parts, powers, displacement, ratio, squared_ratio }
    }

    /// The factor of a harmonic at a power, summed over all parts.
    pub fn sum(&self, order: u32, harmonic: u32) -> Polynomial {
        let factors = self.parts.iter().filter_map(|(_, factors)| factors.get(&(order, harmonic)));
        factors.fold(Polynomial::zero(), |sum, factor| sum + factor.clone())
    }

    /// The contribution of each part to a condition, with the products that it comes from where these are shown.
    pub(super) fn table(&self, condition: &Condition, with_products: bool) -> DerivationTable {
        let key = (condition.order, condition.harmonic);
        let given = self.parts.iter().zip(&self.powers);
        let given = given.filter_map(|((part, factors), power)| Some((part, factors.get(&key)?, power)));
        let rows = given.filter(|(_, factor, _)| !factor.is_zero());
        let rows = rows.map(|(part, factor, power)| {
            let terms = with_products.then(|| self.products(power.as_ref(), key).terms_of(factor)).flatten();
            let products = terms.map(|terms| in_groups_of(&terms));
            [Prose::formula(part.clone()), in_groups(factor)].into_iter().chain(products).collect()
        });
        let k = usize::try_from(condition.harmonic).unwrap_or(usize::MAX);
        let power = letter("ε").pow(i64::from(condition.order));
        let products = with_products.then(|| Prose::text("products that it comes from"));
        let head = [Prose::text("part"), Prose::new("its factor of {} in {}", [cosine(k), power])];
        DerivationTable {
            cells: Cells::Formulas,
            head: head.into_iter().chain(products).collect(),
            rows: rows.collect(),
            note: Prose::text(
                "checked: their sum is what the equation of motion leaves, with exact fractions for all symbols, also for values that are not solutions",
            ),
        }
    }

    /// The products in a part's factor of a harmonic at a power.
    pub(super) fn products(&self, term: Option<&RestoringTerm>, key: (u32, u32)) -> Products {
        match term {
            None => products::linear(&self.displacement, &self.squared_ratio, key),
            Some(term) => products::of_term(&self.displacement, &self.ratio, term, key),
        }
    }
}

/// The terms of a sum in pairs; a line may end between them.
fn in_groups_of(terms: &[Formula]) -> Prose {
    let pairs = terms.chunks(2).enumerate().map(|(index, pair)| {
        let plus = if index > 0 { Prose::text(" + ") } else { Prose(vec![]) };
        plus.and(Prose::formula(sum(pair.to_vec())))
    });
    pairs.fold(Prose(vec![]), Prose::and)
}

/// A sum in groups of terms; a line may end between groups.
fn in_groups(polynomial: &Polynomial) -> Prose {
    const GROUP: usize = 3;
    let terms = match Formula::from(polynomial) {
        Formula::Sum(terms) => terms,
        term => return Prose::formula(term),
    };
    let negative: Vec<bool> = polynomial.terms().map(|(_, factor)| *factor < Rational::from(0)).collect();
    let groups = terms.chunks(GROUP).zip(negative.iter().step_by(GROUP)).enumerate();
    groups.fold(Prose(vec![]), |prose, (index, (group, is_negative))| {
        let mut group = group.to_vec();
        if *is_negative && index > 0 {
            group[0] = group[0].clone().negated();
        }
        let sign = if *is_negative { " − " } else { " + " };
        let prose = if index > 0 { prose.and(Prose::text(sign)) } else { prose };
        prose.and(Prose::formula(sum(group)))
    })
}

/// Δ²u″ + u.
fn linear_part(question: &LindstedtQuestion) -> Formula {
    let second = question.displacement.clone().prime().prime();
    letter("Δ").squared() * Formula::Name(second) + question.u()
}

/// The coefficients of u.
fn displacement(question: &LindstedtQuestion) -> Factors {
    let all =
        question.harmonics().into_iter().flat_map(|k| question.powers().into_iter().map(move |n| (n, k)));
    let mut present = Factors::new();
    for (n, k) in all {
        let name = coefficient_name(k, n);
        if !vanishes(question, &name) {
            present.insert(key(n, k), Polynomial::variable(name));
        }
    }
    present
}

/// Δ.
fn ratio(question: &LindstedtQuestion) -> Factors {
    let mut ratio = Factors::new();
    ratio.insert((0, 0), Polynomial::constant(Rational::from(1)));
    for n in question.powers().into_iter().filter(|n| *n > 1) {
        let (n, _) = key(n - 1, 0);
        ratio.insert((n, 0), Polynomial::variable(Variable::indexed(FREQUENCY, n)));
    }
    ratio
}

/// The factors of sin kτ in Δu′.
fn velocity(question: &LindstedtQuestion, displacement: &Factors) -> Factors {
    let mut slope = Factors::new();
    for ((n, k), coefficient) in displacement.iter().filter(|((_, k), _)| *k > 0) {
        slope.insert((*n, *k), coefficient.scaled(&Rational::from(-i64::from(*k))));
    }
    product(&ratio(question), &slope, question.order)
}

/// uᵖ·(Δu′)^q with an even q, from the shorter products.
fn power(
    products: &mut BTreeMap<[u32; 2], Factors>,
    [displacement, velocity]: [&Factors; 2],
    exponents: [u32; 2],
    order: usize,
) -> Factors {
    let both = [displacement, velocity];
    if let Some(factors) = products.get(&exponents) {
        return factors.clone();
    }
    let factors = match exponents {
        [1, 0] => return displacement.clone(),
        [0, 0] => Factors::from([((0, 0), Polynomial::constant(Rational::from(1)))]),
        [0, 2] => product_of_waves(velocity, velocity, -1, order),
        [0, q] => {
            let square = power(products, both, [0, 2], order);
            product(&power(products, both, [0, q.saturating_sub(2)], order), &square, order)
        }
        [p, q] => product(&power(products, both, [p - 1, q], order), displacement, order),
    };
    products.insert(exponents, factors.clone());
    factors
}

/// The factors of Δ²u″ + u.
fn linear(question: &LindstedtQuestion, displacement: &Factors, squared_ratio: &Factors) -> Factors {
    let mut second = Factors::new();
    for ((n, k), coefficient) in displacement {
        let factor = -i64::from(*k) * i64::from(*k);
        second.insert((*n, *k), coefficient.scaled(&Rational::from(factor)));
    }
    let mut sum = product(squared_ratio, &second, question.order);
    for (key, coefficient) in displacement {
        add(&mut sum, *key, coefficient.clone());
    }
    sum
}

/// The product of two sums of cosines, up to a power of ε.
fn product(a: &Factors, b: &Factors, order: usize) -> Factors {
    product_of_waves(a, b, 1, order)
}

/// The product of two sums of cosines, or with the sign −1 of two sums of sines.
fn product_of_waves(a: &Factors, b: &Factors, sign: i64, order: usize) -> Factors {
    let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
    let mut sum = Factors::new();
    for ((n, j), left) in a {
        for ((m, k), right) in b.iter().filter(|((m, _), _)| n + m <= key(order, 0).0) {
            let each = (left.clone() * right.clone()).scaled(&half);
            add(&mut sum, (n + m, j.abs_diff(*k)), each.clone());
            add(&mut sum, (n + m, j + k), each.scaled(&Rational::from(sign)));
        }
    }
    sum
}

fn add(sum: &mut Factors, key: (u32, u32), polynomial: Polynomial) {
    let entry = sum.entry(key).or_insert_with(Polynomial::zero);
    *entry = std::mem::replace(entry, Polynomial::zero()) + polynomial;
}

/// The key of ε^n cos kτ.
fn key(n: usize, k: usize) -> (u32, u32) {
    let small = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
    (small(n), small(k))
}

/// Returns `true` for the coefficient of a harmonic that does not occur at this order.
pub(super) fn vanishes(question: &LindstedtQuestion, unknown: &Variable) -> bool {
    let value = question.open.solution().get(unknown);
    unknown.letters() != FREQUENCY && value.is_some_and(Polynomial::is_zero)
}
