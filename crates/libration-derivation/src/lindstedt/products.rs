//! The products of coefficients and cosines that make the terms of a condition.

use std::collections::BTreeMap;

use super::super::formula::{Formula, number, scaled};
use libration::algebra::{Polynomial, Rational};
use libration::perturbation::RestoringTerm;

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

    /// Adds a product of a term of the force, unless it vanishes.
    fn add_term(
        &mut self,
        term: &RestoringTerm,
        numbers: [Rational; 2],
        ratio: Polynomial,
        letters: Polynomial,
    ) {
        let value = letters.clone() * ratio.clone() * term.factor.clone();
        let value = numbers.iter().fold(value, |value, number| value.scaled(number));
        if value.is_zero() {
            return;
        }
        let one = Polynomial::constant(Rational::from(1));
        let of = |polynomial: &Polynomial| (*polynomial != one).then(|| Formula::from(polynomial));
        let [orderings, mut share] = numbers;
        let mut first = term.factor.to_constant().unwrap_or_else(|| Rational::from(1));
        if share.is_negative() {
            (first, share) = (-first, -share);
        }
        let shown = [first, orderings, share].into_iter().filter(|factor| *factor != Rational::from(1));
        let symbols = if term.factor.to_constant().is_some() { None } else { of(&term.factor) };
        let factors = shown.map(Formula::Number).chain(symbols).chain(of(&ratio));
        self.add(factors.chain([Formula::from(&letters)]).collect(), value);
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
        let Some(ratio) = squared_ratio.get(&(n - m, 0)).filter(|value| !value.is_zero()) else { continue };
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

/// The products in the factor of cos kτ in εⁿ of a term of the force: its factor, the number of orderings of the coefficients, the factor of
/// cos kτ in the product of their waves, the part of the power of Δ, and the coefficients.
pub(super) fn of_term(
    displacement: &Factors,
    ratio: &Factors,
    term: &RestoringTerm,
    (n, k): (u32, u32),
) -> Products {
    let count = |exponent: u32| usize::try_from(exponent).unwrap_or(usize::MAX);
    let all: Vec<_> = displacement.iter().collect();
    let powers: Vec<u32> = all.iter().map(|((m, _), _)| *m).collect();
    let mut products = Products::new();
    for (of_ratio, part) in power_of_ratio(ratio, term.velocity, n) {
        for split in 0..=(n - of_ratio) {
            for cosines in selections(&powers, count(term.position), n - of_ratio - split) {
                for sines in selections(&powers, count(term.velocity), split) {
                    let harmonics = |chosen: &[usize]| -> Vec<i64> {
                        chosen.iter().map(|index| i64::from(all[*index].0.1)).collect()
                    };
                    let share = share(&harmonics(&cosines), &harmonics(&sines), i64::from(k));
                    let orderings = Rational::from(orderings(&cosines) * orderings(&sines));
                    let one = Polynomial::constant(Rational::from(1));
                    let chosen = cosines.iter().chain(&sines);
                    let letters = chosen.fold(one, |product, index| product * all[*index].1.clone());
                    products.add_term(term, [orderings, share], part.clone(), letters);
                }
            }
        }
    }
    products
}

/// The parts of a power of Δ by powers of ε, up to one of them.
fn power_of_ratio(ratio: &Factors, exponent: u32, highest: u32) -> Vec<(u32, Polynomial)> {
    let one = vec![(0, Polynomial::constant(Rational::from(1)))];
    (0..exponent).fold(one, |power, _| {
        let mut next: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for (n, left) in power {
            for ((m, _), right) in ratio.iter().filter(|((m, _), _)| n + m <= highest) {
                let entry = next.entry(n + m).or_insert_with(Polynomial::zero);
                *entry = std::mem::replace(entry, Polynomial::zero()) + left.clone() * right.clone();
            }
        }
        next.into_iter().collect()
    })
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
        for index in (first..powers.len()).filter(|index| powers[*index] <= sum) {
            chosen.push(index);
            extend(powers, index, count - 1, sum - powers[index], chosen, all);
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
    for (index, count) in chosen.iter().zip(1_i64..) {
        let repeated = repetitions.entry(index).or_insert(0_i64);
        *repeated += 1;
        product = product * count / *repeated;
    }
    product
}

/// The factor of cos kτ in the product of cosines, and of the derivatives −j·sin jτ of an even number of further ones: the part of the choices
/// of signs with ±k₁ ± k₂ … = ±k. A sine is half the difference of its two exponentials over i.
fn share(cosines: &[i64], slopes: &[i64], k: i64) -> Rational {
    let waves = cosines.iter().map(|cosine| (*cosine, 1)).chain(slopes.iter().map(|slope| (*slope, -1)));
    let mut sums = BTreeMap::from([(0_i64, 1_i64)]);
    for (harmonic, sign) in waves {
        let mut next = BTreeMap::new();
        for (sum, count) in sums {
            *next.entry(sum + harmonic).or_insert(0) += count;
            *next.entry(sum - harmonic).or_insert(0) += sign * count;
        }
        sums = next;
    }
    let count = |sum: i64| sums.get(&sum).copied().unwrap_or(0);
    let right = if k == 0 { count(0) } else { count(k) + count(-k) };
    let choices = (0..cosines.len() + slopes.len()).fold(1, |product: i64, _| product.saturating_mul(2));
    let of_slopes: i64 = slopes.iter().product();
    let sign = if slopes.len() % 4 == 2 { -1 } else { 1 };
    Rational::new(sign * of_slopes * right, choices).unwrap_or_else(|| Rational::from(0))
}
