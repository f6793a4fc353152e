//! Origins of the terms of a condition: the parts of the equation of motion, before the results of lower orders are inserted.

use std::collections::BTreeMap;

use super::super::document::{Cells, DerivationTable};
use super::super::formula::{Formula, letter, monomial, sum};
use super::super::prose::Prose;
use super::names::{coefficient_name, cosine};
use super::question::Question;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::Condition;

/// The symbol of the corrections of the frequency.
const FREQUENCY: &str = "d";

/// The factor of each harmonic at each power of ε.
type Factors = BTreeMap<(u32, u32), Polynomial>;

/// Parts of the equation of motion with their contributions to the conditions; vanishing coefficients are omitted.
#[derive(Debug)]
pub struct Contributions {
    /// Each part with its factors, by the power of ε and the harmonic.
    pub parts: Vec<(Formula, Factors)>,
}

impl Contributions {
    /// Computes the contribution of each part of the equation of motion.
    pub fn new(question: &Question) -> Self {
        let displacement = displacement(question);
        let mut parts = vec![(linear_part(question), linear(question, &displacement))];
        let mut power = displacement.clone();
        for (place, factor) in question.force.iter().enumerate().skip(1) {
            power = product(&power, &displacement, question.order);
            if !factor.is_zero() {
                let mut factors = Factors::new();
                for (key, it) in &power {
                    factors.insert(*key, it.scaled(factor));
                }
                parts.push((monomial(factor, &question.u(), place + 1), factors));
            }
        }
        Self { parts }
    }

    /// The factor of a harmonic at a power, summed over all parts.
    pub fn sum(&self, order: u32, harmonic: u32) -> Polynomial {
        let factors = self.parts.iter().filter_map(|(_, factors)| factors.get(&(order, harmonic)));
        factors.fold(Polynomial::zero(), |sum, factor| sum + factor.clone())
    }

    /// The contribution of each part to a condition.
    pub(super) fn table(&self, condition: &Condition) -> DerivationTable {
        let key = (condition.order, condition.harmonic);
        let given = self.parts.iter().filter_map(|(part, factors)| Some((part, factors.get(&key)?)));
        let rows = given.filter(|(_, factor)| !factor.is_zero());
        let rows = rows.map(|(part, factor)| vec![Prose::formula(part.clone()), in_groups(factor)]);
        let k = usize::try_from(condition.harmonic).unwrap_or(usize::MAX);
        let power = letter("ε").pow(i64::from(condition.order));
        let head = vec![Prose::text("part"), Prose::new("its factor of {} in {}", [cosine(k), power])];
        DerivationTable {
            cells: Cells::Formulas,
            head,
            rows: rows.collect(),
            note: Prose::text(
                "checked: their sum is what the equation of motion leaves, with exact fractions for all symbols, also for values that are not solutions",
            ),
        }
    }
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
    groups.fold(Prose(vec![]), |prose, (place, (group, is_negative))| {
        let mut group = group.to_vec();
        if *is_negative && place > 0 {
            group[0] = group[0].clone().negated();
        }
        let sign = if *is_negative { " − " } else { " + " };
        let prose = if place > 0 { prose.and(Prose::text(sign)) } else { prose };
        prose.and(Prose::formula(sum(group)))
    })
}

/// Δ²u″ + u.
fn linear_part(question: &Question) -> Formula {
    let second = question.displacement.clone().prime().prime();
    letter("Δ").squared() * Formula::Name(second) + question.u()
}

/// The coefficients of u.
fn displacement(question: &Question) -> Factors {
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

/// The factors of Δ²u″ + u.
fn linear(question: &Question, displacement: &Factors) -> Factors {
    let one = Polynomial::constant(Rational::from(1));
    let mut ratio = Factors::new();
    ratio.insert((0, 0), one);
    for n in question.powers().into_iter().filter(|n| *n > 1) {
        let (n, _) = key(n - 1, 0);
        ratio.insert((n, 0), Polynomial::variable(Variable::indexed(FREQUENCY, n)));
    }
    let mut second = Factors::new();
    for ((n, k), it) in displacement {
        let factor = -i64::from(*k) * i64::from(*k);
        second.insert((*n, *k), it.scaled(&Rational::from(factor)));
    }
    let squared = product(&ratio, &ratio, question.order);
    let mut sum = product(&squared, &second, question.order);
    for (key, it) in displacement {
        add(&mut sum, *key, it.clone());
    }
    sum
}

/// The product of two sums of cosines, up to a power of ε.
fn product(a: &Factors, b: &Factors, order: usize) -> Factors {
    let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
    let mut sum = Factors::new();
    for ((n, j), left) in a {
        for ((m, k), right) in b.iter().filter(|((m, _), _)| n + m <= key(order, 0).0) {
            let each = (left.clone() * right.clone()).scaled(&half);
            add(&mut sum, (n + m, j.abs_diff(*k)), each.clone());
            add(&mut sum, (n + m, j + k), each);
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
pub(super) fn vanishes(question: &Question, unknown: &Variable) -> bool {
    let value = question.open.solution().get(unknown);
    unknown.letters() != FREQUENCY && value.is_some_and(Polynomial::is_zero)
}
