//! Where the terms of a condition come from: the parts of the equation of motion, before what lower orders have found is put in.

use std::collections::BTreeMap;

use super::super::document::DerivationTable;
use super::super::formula::{Formula, letter, monomial};
use super::super::prose::Prose;
use super::ansatz::cosine;
use super::question::Question;
use libration::algebra::{Polynomial, Rational, Variable};
use libration::perturbation::{Condition, EpsilonPowers, OpenGauge};

/// The letter of the frequency's corrections.
const FREQUENCY: &str = "d";

/// The factor of each harmonic in each power of ε.
type Factors = BTreeMap<(u32, u32), Polynomial>;

/// Parts of the equation of motion with what each gives to the conditions; coefficients that vanish are left out.
pub(super) struct Contributions {
    pub(super) parts: Vec<(Formula, Factors)>,
}

impl Contributions {
    /// Those up to an order; `None` where they have too many terms.
    pub(super) fn new(question: &Question, order: usize) -> Option<Self> {
        let force: Vec<Rational> = question.force.iter().take(order).cloned().collect();
        let whole = |powers: &[(usize, Rational)]| whole(question, order, powers);
        let minus = Rational::from(-1);
        // An even power is always there where the force has one, since the ansatz depends on that.
        let even = (1..=force.len()).find(|power| power % 2 == 0 && !force[power - 1].is_zero());
        let one: Vec<(usize, Rational)> = even.map(|power| (power, Rational::from(1))).into_iter().collect();
        let two: Vec<(usize, Rational)> = even.map(|power| (power, Rational::from(2))).into_iter().collect();
        let base = whole(&one)?;
        let even_part = combined(&whole(&two)?, &base, &minus);
        let linear = combined(&base, &even_part, &minus);
        let mut parts = vec![(linear_part(question), linear)];
        for (place, factor) in force.iter().enumerate().skip(1).filter(|(_, factor)| !factor.is_zero()) {
            let power = place + 1;
            let factors = match even == Some(power) {
                true => even_part.iter().map(|(key, it)| (*key, it.scaled(factor))).collect(),
                false => combined(&whole(&[&one[..], &[(power, factor.clone())]].concat())?, &base, &minus),
            };
            parts.push((monomial(factor, &question.u(), power), factors));
        }
        Some(Self { parts })
    }

    /// The factor of a harmonic in a power, of all parts together.
    pub(super) fn sum(&self, order: u32, harmonic: u32) -> Polynomial {
        let factors = self.parts.iter().filter_map(|(_, factors)| factors.get(&(order, harmonic)));
        factors.fold(Polynomial::zero(), |sum, factor| sum + factor.clone())
    }

    /// What each part gives to a condition.
    pub(super) fn table(&self, condition: &Condition) -> DerivationTable {
        let key = (condition.order, condition.harmonic);
        let given = self.parts.iter().filter_map(|(part, factors)| Some((part, factors.get(&key)?)));
        let rows = given.filter(|(_, factor)| !factor.is_zero());
        let rows = rows.map(|(part, factor)| vec![part.clone(), Formula::from(factor)]);
        let k = usize::try_from(condition.harmonic).unwrap_or(usize::MAX);
        let power = letter("ε").pow(i64::from(condition.order));
        let head = vec![Prose::text("part"), Prose::new("its factor of {} in {}", [cosine(k), power])];
        DerivationTable {
            head,
            rows: rows.map(|row| row.into_iter().map(Prose::formula).collect()).collect(),
            note: Prose::text(
                "checked: their sum is what the equation of motion leaves, with exact fractions for all letters, also such as solve nothing",
            ),
        }
    }
}

/// Δ²u″ + u.
fn linear_part(question: &Question) -> Formula {
    let second = question.displacement.clone().prime().prime();
    letter("Δ").squared() * Formula::Name(second) + question.u()
}

/// The conditions of a force u + Σ fₚuᵖ, with nothing inserted but the coefficients that vanish.
fn whole(question: &Question, order: usize, powers: &[(usize, Rational)]) -> Option<Factors> {
    let mut force = vec![Rational::from(0); order.max(1)];
    force[0] = Rational::from(1);
    for (power, factor) in powers {
        *force.get_mut(power - 1)? = factor.clone();
    }
    let parity = if question.powers().contains(&2) { EpsilonPowers::All } else { EpsilonPowers::OneParity };
    let conditions = OpenGauge::new(&force, u32::try_from(order).ok()?, parity).ok()?.whole_system()?;
    let vanishing: Vec<&Variable> =
        question.open.solution().keys().filter(|it| vanishes(question, it)).collect();
    let left = |polynomial: Polynomial| {
        vanishing.iter().fold(polynomial, |left, unknown| left.substitute(unknown, &Polynomial::zero()))
    };
    Some(conditions.into_iter().map(|it| ((it.order, it.harmonic), left(it.polynomial))).collect())
}

/// Whether it is a coefficient of a harmonic that is not made at this order.
pub(super) fn vanishes(question: &Question, unknown: &Variable) -> bool {
    let value = question.open.solution().get(unknown);
    unknown.letters() != FREQUENCY && value.is_some_and(Polynomial::is_zero)
}

/// a + factor·b.
fn combined(a: &Factors, b: &Factors, factor: &Rational) -> Factors {
    let other = |key| b.get(key).map_or_else(Polynomial::zero, |it| it.scaled(factor));
    a.iter().map(|(key, it)| (*key, it.clone() + other(key))).collect()
}
