//! The products of coefficients and cosines that make the terms of a condition.

use std::collections::BTreeMap;

use super::super::formula::{Formula, number, scaled};
use libration::algebra::{Polynomial, Rational};

/// The factor of each harmonic at each power of ε.
pub(super) type Factors = BTreeMap<(u32, u32), Polynomial>;

/// A sum of products, printed with its factors, and its value.
pub(super) struct Products {
    terms: Vec<Formula>,
    sum: Polynomial,
}

impl Products {
    fn new() -> Self {
        Self { terms: vec![], sum: Polynomial::zero() }
    }

    fn add(&mut self, factors: Vec<Formula>, value: Polynomial) {
        self.terms.push(product(factors));
        self.sum = std::mem::replace(&mut self.sum, Polynomial::zero()) + value;
    }

    /// The products, if their sum is this.
    pub(super) fn terms_of(self, expected: &Polynomial) -> Option<Vec<Formula>> {
        (self.sum == *expected).then_some(self.terms)
    }
}

/// The products in the factor of cos kτ in εⁿ of Δ²u″ + u: 1 − k² times the coefficient of this power, and −k² times the parts of Δ² times
/// the coefficients of lower ones.
pub(super) fn linear(displacement: &Factors, squared_ratio: &Factors, (n, k): (u32, u32)) -> Products {
    let mut products = Products::new();
    let minus_square = Rational::from(-i64::from(k) * i64::from(k));
    for ((m, _), coefficient) in displacement.iter().filter(|((m, j), _)| *j == k && *m <= n) {
        let letter = Formula::from(coefficient);
        let Some(ratio) = squared_ratio.get(&(n - m, 0)).filter(|it| !it.is_zero()) else { continue };
        let value = (ratio.clone() * coefficient.clone()).scaled(&minus_square);
        match (n == *m, k) {
            (true, 1) => products.sum = products.sum.clone() + value + coefficient.clone(),
            (true, 0) => products.add(vec![letter], coefficient.clone()),
            (true, _) => {
                let factor = number(1) - number(i64::from(k)).squared();
                products.add(vec![factor, letter], value + coefficient.clone());
            }
            (false, 0) => {}
            (false, _) => {
                let factors = scaled(&minus_square, Formula::from(ratio) * letter);
                products.add(vec![factors], value);
            }
        }
    }
    products
}

/// The products in the factor of cos kτ in εⁿ of a power of u times a number: the number, the number of orderings of the coefficients, the
/// factor of cos kτ in the product of their cosines, and the coefficients.
pub(super) fn of_power(
    displacement: &Factors,
    (factor, exponent): (&Rational, usize),
    (n, k): (u32, u32),
) -> Products {
    let all: Vec<_> = displacement.iter().collect();
    let mut products = Products::new();
    for chosen in selections(&all.iter().map(|((m, _), _)| *m).collect::<Vec<_>>(), exponent, n) {
        let harmonics: Vec<i64> = chosen.iter().map(|place| i64::from(all[*place].0.1)).collect();
        let share = share(&harmonics, i64::from(k));
        if share.is_zero() {
            continue;
        }
        let orderings = Rational::from(orderings(&chosen));
        let one = Polynomial::constant(Rational::from(1));
        let letters = chosen.iter().fold(one, |product, place| product * all[*place].1.clone());
        let numbers = [factor.clone(), orderings, share];
        let value = numbers.iter().fold(letters.clone(), |value, it| value.scaled(it));
        let shown = numbers.iter().filter(|it| **it != Rational::from(1)).cloned().map(Formula::Number);
        products.add(shown.chain([Formula::from(&letters)]).collect(), value);
    }
    products
}

/// The product of factors, of which the last may be a product.
fn product(mut factors: Vec<Formula>) -> Formula {
    match factors.pop() {
        Some(last) if factors.is_empty() => last,
        Some(Formula::Product(letters)) => Formula::Product(factors.into_iter().chain(letters).collect()),
        last => Formula::Product(factors.into_iter().chain(last).collect()),
    }
}

/// The choices of this many places, ascending, whose powers have a sum.
fn selections(powers: &[u32], count: usize, sum: u32) -> Vec<Vec<usize>> {
    fn extend(
        powers: &[u32],
        first: usize,
        count: usize,
        sum: u32,
        chosen: &mut Vec<usize>,
        all: &mut Vec<Vec<usize>>,
    ) {
        if count == 0 {
            if sum == 0 {
                all.push(chosen.clone());
            }
            return;
        }
        for place in (first..powers.len()).filter(|place| powers[*place] <= sum) {
            chosen.push(place);
            extend(powers, place, count - 1, sum - powers[place], chosen, all);
            chosen.pop();
        }
    }
    let mut all = vec![];
    extend(powers, 0, count, sum, &mut vec![], &mut all);
    all
}

/// The number of orderings of a choice: count! over the factorials of the repetitions.
fn orderings(chosen: &[usize]) -> i64 {
    let mut repetitions = BTreeMap::new();
    let mut product = 1;
    for (place, count) in chosen.iter().zip(1_i64..) {
        let repeated = repetitions.entry(place).or_insert(0_i64);
        *repeated += 1;
        product = product * count / *repeated;
    }
    product
}

/// The factor of cos kτ in the product of cosines: the part of the choices of signs with ±k₁ ± k₂ … = ±k.
fn share(harmonics: &[i64], k: i64) -> Rational {
    let mut sums = BTreeMap::from([(0_i64, 1_i64)]);
    for harmonic in harmonics {
        let mut next = BTreeMap::new();
        for (sum, count) in sums {
            *next.entry(sum + harmonic).or_insert(0) += count;
            *next.entry(sum - harmonic).or_insert(0) += count;
        }
        sums = next;
    }
    let count = |sum: i64| sums.get(&sum).copied().unwrap_or(0);
    let right = if k == 0 { count(0) } else { count(k) + count(-k) };
    let choices = (0..harmonics.len()).fold(1, |product: i64, _| product.saturating_mul(2));
    Rational::new(right, choices).unwrap_or_else(|| Rational::from(0))
}
