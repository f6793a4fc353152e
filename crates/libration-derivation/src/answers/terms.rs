//! The terms of a sum of products of powers, sines and cosines.
//!
//! # Method
//! A product of sines and cosines is expanded by exponentials: cos φ = (e^{iφ} + e^{−iφ})/2, sin φ = (e^{iφ} − e^{−iφ})/(2i), so that a product
//! of two has the sums of their phases, and both ways to write it have the same terms.

use super::super::formula::{Formula, cos, scaled, sin, sum};
use libration::algebra::{Function, Rational};
use std::collections::{BTreeMap, BTreeSet};

/// Largest number of products of terms in a product of sums; the longest result, of order 9, needs 1000.
const MOST_PRODUCTS: usize = 5000;
/// Largest power of a sum that is expanded.
const HIGHEST_POWER: u64 = 40;
/// Largest number of bits of a coefficient, above those of each derivation of order 9.
const MOST_BITS: usize = 4000;

/// The exponents of the symbols of a product.
type Powers = BTreeMap<String, Rational>;
/// A phase: a sum of products.
type Phase = BTreeMap<Powers, Rational>;

/// A product of powers and an exponential of i times a phase.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Product {
    powers: Powers,
    phase: Phase,
}

/// The function of the phase in a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Wave {
    Cosine,
    Sine,
}

/// A term without its coefficient.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Term {
    powers: Powers,
    phase: Phase,
    wave: Wave,
}

/// The coefficients of terms that differ.
pub(super) type Terms = BTreeMap<Term, Rational>;

/// The terms of a formula, without O(…); `None` if it is not a sum of products of powers, sines and cosines. `atom` gives the key of what is
/// treated as a symbol.
pub(super) fn terms(formula: &Formula, atom: &dyn Fn(&Formula) -> Option<String>) -> Option<Terms> {
    let mut terms = Terms::new();
    for (Product { powers, phase }, [real, imaginary]) in expanded(formula, atom)? {
        // Of a phase and its negative, one stands for both.
        let Some(first) = phase.values().next() else {
            terms.insert(Term { powers, phase, wave: Wave::Cosine }, real);
            continue;
        };
        if first.is_negative() {
            continue;
        }
        let two = Rational::from(2);
        let waves = [(Wave::Cosine, real * two.clone()), (Wave::Sine, -imaginary * two)];
        for (wave, coefficient) in waves.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()) {
            terms.insert(Term { powers: powers.clone(), phase: phase.clone(), wave }, coefficient);
        }
    }
    Some(terms)
}

/// Returns `true` if a sum is another one times a product of powers and a number.
pub(super) fn is_multiple(sum: &Terms, of: &Terms) -> bool {
    let Some((first, one)) = of.iter().next() else { return false };
    sum.len() == of.len()
        && sum.iter().any(|(term, coefficient)| {
            let factor = over(&term.powers, &first.powers);
            let Some(number) = coefficient.checked_div(one) else { return false };
            of.iter().all(|(term, coefficient)| {
                let powers = times(&term.powers, &factor);
                let own = sum.get(&Term { powers, ..term.clone() });
                own == Some(&(coefficient.clone() * number.clone()))
            })
        })
}

/// The sum times the product of powers that gives most of its terms those of another sum, and the number that does so for their coefficients.
pub(super) fn as_in(sum: Terms, other: &Terms) -> Terms {
    let shifted = |factor: &Powers| -> Terms {
        let shifted = |(term, value): (&Term, &Rational)| {
            (Term { powers: times(&term.powers, factor), ..term.clone() }, value.clone())
        };
        sum.iter().map(shifted).collect()
    };
    let pairs = sum.keys().flat_map(|own| other.keys().map(move |term| over(&term.powers, &own.powers)));
    let factors: BTreeSet<Powers> = [Powers::new()].into_iter().chain(pairs).collect();
    let common = |sum: &Terms| sum.keys().filter(|term| other.contains_key(term)).count();
    let best = factors
        .iter()
        .map(shifted)
        .reduce(|best, next| if common(&next) > common(&best) { next } else { best });
    let best = best.unwrap_or_default();
    let ratios: Vec<Rational> =
        best.iter().filter_map(|(term, own)| other.get(term)?.checked_div(own)).collect();
    let count = |ratio: &&Rational| ratios.iter().filter(|it| it == ratio).count();
    let Some(factor) = ratios.iter().max_by_key(count).cloned() else { return best };
    best.into_iter().map(|(term, own)| (term, own * factor.clone())).collect()
}

impl Term {
    /// The term as a formula; `None` if it is a number.
    pub(super) fn to_formula(&self, name: &dyn Fn(&str) -> Formula) -> Option<Formula> {
        let wave = (!self.phase.is_empty()).then(|| {
            let parts = self.phase.iter().map(|(powers, coefficient)| match product(powers, name) {
                Some(product) => scaled(coefficient, product),
                None => Formula::Number(coefficient.clone()),
            });
            let phase = sum(parts.collect());
            if self.wave == Wave::Cosine { cos(phase) } else { sin(phase) }
        });
        product(&self.powers, name).into_iter().chain(wave).reduce(|product, factor| product * factor)
    }
}

fn product(powers: &Powers, name: &dyn Fn(&str) -> Formula) -> Option<Formula> {
    let power = |(key, exponent): (&String, &Rational)| match *exponent == Rational::from(1) {
        true => name(key),
        false => name(key).pow(exponent.clone()),
    };
    powers.iter().map(power).reduce(|product, factor| product * factor)
}

type Expansion = BTreeMap<Product, [Rational; 2]>;

fn expanded(formula: &Formula, atom: &dyn Fn(&Formula) -> Option<String>) -> Option<Expansion> {
    let of = |formula: &Formula| expanded(formula, atom);
    if let Some(key) = atom(formula) {
        return Some(symbol(key));
    }
    Some(match formula {
        Formula::Number(value) => constant(value.clone()),
        Formula::Order(_) => Expansion::new(),
        Formula::Negate(it) => multiplied(&constant(Rational::from(-1)), &of(it)?)?,
        Formula::Sum(parts) => {
            let mut sum = Expansion::new();
            for part in parts {
                of(part)?.into_iter().for_each(|(product, value)| add(&mut sum, product, value));
            }
            sum
        }
        Formula::Product(factors) => {
            let one = constant(Rational::from(1));
            factors.iter().try_fold(one, |product, factor| multiplied(&product, &of(factor)?))?
        }
        Formula::Fraction(over, under) => multiplied(&of(over)?, &raised(&of(under)?, &Rational::from(-1))?)?,
        Formula::Power(base, exponent) => raised(&of(base)?, &fraction(exponent)?)?,
        Formula::Call(Function::Sqrt, it) => raised(&of(it)?, &Rational::new(1, 2)?)?,
        Formula::Call(Function::Cos, it) => {
            let half = Rational::new(1, 2)?;
            wave(&of(it)?, [half.clone(), Rational::from(0)], [half, Rational::from(0)])?
        }
        Formula::Call(Function::Sin, it) => {
            let half = Rational::new(1, 2)?;
            wave(&of(it)?, [Rational::from(0), -half.clone()], [Rational::from(0), half])?
        }
        _ => return None,
    })
}

fn constant(value: Rational) -> Expansion {
    let mut sum = Expansion::new();
    add(&mut sum, Product::default(), [value, Rational::from(0)]);
    sum
}

fn symbol(key: String) -> Expansion {
    let powers = Powers::from([(key, Rational::from(1))]);
    Expansion::from([(Product { powers, phase: Phase::new() }, [Rational::from(1), Rational::from(0)])])
}

fn add(sum: &mut Expansion, product: Product, [real, imaginary]: [Rational; 2]) {
    let zero = || [Rational::from(0), Rational::from(0)];
    let [old_real, old_imaginary] = sum.remove(&product).unwrap_or_else(zero);
    let value = [old_real + real, old_imaginary + imaginary];
    if value.iter().any(|part| !part.is_zero()) {
        sum.insert(product, value);
    }
}

fn multiplied(a: &Expansion, b: &Expansion) -> Option<Expansion> {
    if a.len() * b.len() > MOST_PRODUCTS {
        return None;
    }
    let mut sum = Expansion::new();
    for (one, [p, q]) in a {
        for (other, [r, s]) in b {
            let powers = times(&one.powers, &other.powers);
            let phase = times(&one.phase, &other.phase);
            let real = p.clone() * r.clone() - q.clone() * s.clone();
            let imaginary = p.clone() * s.clone() + q.clone() * r.clone();
            add(&mut sum, Product { powers, phase }, [real, imaginary]);
        }
    }
    let is_long = |value: &[Rational; 2]| value.iter().any(|part| part.bits() > MOST_BITS);
    if sum.values().any(is_long) { None } else { Some(sum) }
}

/// The product of two products of powers, or the sum of two phases.
fn times<K: Clone + Ord>(a: &BTreeMap<K, Rational>, b: &BTreeMap<K, Rational>) -> BTreeMap<K, Rational> {
    let mut product = a.clone();
    for (key, exponent) in b {
        let old = product.remove(key).unwrap_or_else(|| Rational::from(0));
        let exponent = old + exponent.clone();
        if !exponent.is_zero() {
            product.insert(key.clone(), exponent);
        }
    }
    product
}

fn over(a: &Powers, b: &Powers) -> Powers {
    times(a, &b.iter().map(|(key, exponent)| (key.clone(), -exponent.clone())).collect())
}

/// A number that is written as one.
fn fraction(formula: &Formula) -> Option<Rational> {
    match formula {
        Formula::Number(value) => Some(value.clone()),
        Formula::Negate(it) => Some(-fraction(it)?),
        Formula::Fraction(over, under) => fraction(over)?.checked_div(&fraction(under)?),
        _ => None,
    }
}

/// A power: of a sum if the exponent is a small natural number, otherwise of a product of powers.
fn raised(base: &Expansion, exponent: &Rational) -> Option<Expansion> {
    if let Some(n) = exponent.to_natural().filter(|&n| n <= HIGHEST_POWER) {
        return (0..n).try_fold(constant(Rational::from(1)), |power, _| multiplied(&power, base));
    }
    let (Product { powers, phase }, [real, imaginary]) = base.iter().next().filter(|_| base.len() == 1)?;
    if !phase.is_empty() || !imaginary.is_zero() {
        return None;
    }
    let doubled = exponent.clone() + exponent.clone();
    let n = isize::try_from(doubled.magnitude().to_natural().filter(|&n| n <= HIGHEST_POWER)?).ok()?;
    let n = if exponent.is_negative() { -n } else { n };
    let coefficient = match n % 2 == 0 {
        true => real.integer_power(n / 2)?,
        false => real.square_root()?.integer_power(n)?,
    };
    let powers = powers.iter().map(|(key, own)| (key.clone(), own.clone() * exponent.clone())).collect();
    Some(Expansion::from([(Product { powers, phase: Phase::new() }, [coefficient, Rational::from(0)])]))
}

/// The exponentials of i and −i times a phase, each with its coefficient.
fn wave(phase: &Expansion, plus: [Rational; 2], minus: [Rational; 2]) -> Option<Expansion> {
    if phase.iter().any(|(product, [_, imaginary])| !product.phase.is_empty() || !imaginary.is_zero()) {
        return None;
    }
    let phase: Phase =
        phase.iter().map(|(product, [real, _])| (product.powers.clone(), real.clone())).collect();
    let opposite = phase.iter().map(|(powers, value)| (powers.clone(), -value.clone())).collect();
    let mut sum = Expansion::new();
    add(&mut sum, Product { powers: Powers::new(), phase }, plus);
    add(&mut sum, Product { powers: Powers::new(), phase: opposite }, minus);
    Some(sum)
}
