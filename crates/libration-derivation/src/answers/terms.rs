//! The terms of a sum of products of powers, sines and cosines.
//!
//! # Method
//! A product of sines and cosines is expanded by exponentials: cos φ = (e^{iφ} + e^{−iφ})/2, sin φ = (e^{iφ} − e^{−iφ})/(2i), so that a product
//! of two has the sums of their phases, and both ways to write it have the same terms.

use super::super::formula::{Formula, cos, scaled, sin, sum};
use libration::algebra::{Function, Rational};

// Results of orders up to 9 need 4 products of terms and 62 bits; the limits are for answers with brackets, and keep a product below a tenth of a second.
/// Largest number of products of terms in a product of sums.
const MOST_PRODUCTS: usize = 5000;
/// Largest power of a sum that is expanded.
const HIGHEST_POWER: u64 = 40;
/// Largest number of bits of a coefficient.
const MOST_BITS: usize = 4000;

/// Numbers by keys in ascending order, without zeros.
type Sparse<K> = Vec<(K, Rational)>;
/// The exponents of the symbols of a product.
type Powers = Sparse<usize>;

/// A term without its coefficient.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Term {
    powers: Powers,
    phase: Sparse<Powers>,
    /// `true` for the sine of the phase in place of its cosine; in exponentials, for a factor of i.
    is_odd: bool,
}

/// The coefficients of terms that differ.
pub(super) type Terms = Sparse<Term>;

/// The terms of a formula, without O(…); `None` if it is not a sum of products of powers, sines and cosines. `atom` numbers what is treated as
/// a symbol.
pub(super) fn terms(formula: &Formula, atom: &dyn Fn(&Formula) -> Option<usize>) -> Option<Terms> {
    let mut terms = Terms::new();
    for (term, coefficient) in expanded(formula, atom)? {
        // Of a phase and its negative, one stands for both.
        match term.phase.first() {
            None => put(&mut terms, term, coefficient),
            Some((_, first)) if first.is_negative() => {}
            Some(_) => {
                let factor = if term.is_odd { -2 } else { 2 };
                put(&mut terms, term, coefficient * Rational::from(factor));
            }
        }
    }
    Some(terms)
}

/// The coefficient of a term; `None` if the sum does not have it.
pub(super) fn coefficient<'a>(terms: &'a Terms, term: &Term) -> Option<&'a Rational> {
    terms.binary_search_by(|(other, _)| other.cmp(term)).ok().map(|index| &terms[index].1)
}

/// Returns `true` if a sum is another one times a product of powers and a number.
pub(super) fn is_multiple(sum: &Terms, of: &Terms) -> bool {
    let Some((first, one)) = of.first() else { return false };
    let is_factor = |(term, value): &(Term, Rational)| {
        let Some(number) = value.checked_div(one) else { return false };
        let shift = over(&term.powers, &first.powers);
        of.iter().all(|(term, value)| {
            coefficient(sum, &shifted(term, &shift)) == Some(&(value.clone() * number.clone()))
        })
    };
    sum.len() == of.len() && sum.iter().any(is_factor)
}

/// The sum times the product of powers that gives most of its terms those of another sum, and the number that does so for their coefficients.
pub(super) fn as_in(sum: &Terms, other: &Terms) -> Terms {
    let (Some((first, _)), Some((leading, _))) = (sum.first(), other.first()) else { return sum.clone() };
    let up = other.iter().map(|(term, _)| over(&term.powers, &first.powers));
    let down = sum.iter().map(|(term, _)| over(&leading.powers, &term.powers));
    let common = |shift: &Powers| {
        sum.iter().filter(|(term, _)| coefficient(other, &shifted(term, shift)).is_some()).count()
    };
    let mut best = Powers::new();
    for shift in up.chain(down) {
        if common(&shift) > common(&best) {
            best = shift;
        }
    }
    let ratio =
        |(term, value): &(Term, Rational)| coefficient(other, &shifted(term, &best))?.checked_div(value);
    let ratios: Vec<Rational> = sum.iter().filter_map(ratio).collect();
    let count = |ratio: &&Rational| ratios.iter().filter(|candidate| candidate == ratio).count();
    let factor = ratios.iter().max_by_key(count).cloned().unwrap_or_else(|| Rational::from(1));
    let mut scaled = Terms::new();
    for (term, value) in sum {
        put(&mut scaled, shifted(term, &best), value.clone() * factor.clone());
    }
    scaled
}

impl Term {
    /// The term as a formula of the numbered symbols; `None` if it is a number.
    pub(super) fn to_formula(&self, symbol: &dyn Fn(usize) -> Formula) -> Option<Formula> {
        let wave = (!self.phase.is_empty()).then(|| {
            let parts = self.phase.iter().map(|(powers, coefficient)| match product(powers, symbol) {
                Some(product) => scaled(coefficient, product),
                None => Formula::Number(coefficient.clone()),
            });
            let phase = sum(parts.collect());
            if self.is_odd { sin(phase) } else { cos(phase) }
        });
        product(&self.powers, symbol).into_iter().chain(wave).reduce(|product, factor| product * factor)
    }
}

fn product(powers: &Powers, symbol: &dyn Fn(usize) -> Formula) -> Option<Formula> {
    let power = |(number, exponent): &(usize, Rational)| match *exponent == Rational::from(1) {
        true => symbol(*number),
        false => symbol(*number).pow(exponent.clone()),
    };
    powers.iter().map(power).reduce(|product, factor| product * factor)
}

/// The sum as products of powers and exponentials of i times phases.
fn expanded(formula: &Formula, atom: &dyn Fn(&Formula) -> Option<usize>) -> Option<Terms> {
    let of = |formula: &Formula| expanded(formula, atom);
    if let Some(number) = atom(formula) {
        let powers = vec![(number, Rational::from(1))];
        return Some(vec![(Term { powers, ..Term::default() }, Rational::from(1))]);
    }
    Some(match formula {
        Formula::Number(value) => constant(value.clone()),
        Formula::Order(_) => Terms::new(),
        Formula::Negate(operand) => multiplied(&constant(Rational::from(-1)), &of(operand)?)?,
        Formula::Sum(parts) => {
            let mut sum = Terms::new();
            for part in parts {
                of(part)?.into_iter().for_each(|(term, value)| put(&mut sum, term, value));
            }
            sum
        }
        Formula::Product(factors) => {
            let one = constant(Rational::from(1));
            factors.iter().try_fold(one, |product, factor| multiplied(&product, &of(factor)?))?
        }
        Formula::Fraction(over, under) => multiplied(&of(over)?, &raised(&of(under)?, &Rational::from(-1))?)?,
        Formula::Power(base, exponent) => raised(&of(base)?, &fraction(exponent)?)?,
        Formula::Call(Function::Sqrt, argument) => raised(&of(argument)?, &Rational::new(1, 2)?)?,
        Formula::Call(Function::Cos, argument) => wave(&of(argument)?, false)?,
        Formula::Call(Function::Sin, argument) => wave(&of(argument)?, true)?,
        _ => return None,
    })
}

fn constant(value: Rational) -> Terms {
    let mut sum = Terms::new();
    put(&mut sum, Term::default(), value);
    sum
}

/// Adds a number to that of a key.
fn put<K: Ord>(sum: &mut Sparse<K>, key: K, value: Rational) {
    match sum.binary_search_by(|(other, _)| other.cmp(&key)) {
        Ok(index) => {
            let value = sum[index].1.clone() + value;
            if value.is_zero() {
                sum.remove(index);
            } else {
                sum[index].1 = value;
            }
        }
        Err(_) if value.is_zero() => {}
        Err(index) => sum.insert(index, (key, value)),
    }
}

fn multiplied(a: &Terms, b: &Terms) -> Option<Terms> {
    if a.len() * b.len() > MOST_PRODUCTS {
        return None;
    }
    let mut sum = Terms::new();
    for (one, p) in a {
        for (other, q) in b {
            let powers = times(&one.powers, &other.powers);
            let phase = times(&one.phase, &other.phase);
            let value = p.clone() * q.clone();
            let value = if one.is_odd && other.is_odd { -value } else { value };
            put(&mut sum, Term { powers, phase, is_odd: one.is_odd != other.is_odd }, value);
        }
    }
    if sum.iter().any(|(_, value)| value.bits() > MOST_BITS) { None } else { Some(sum) }
}

/// The product of two products of powers, or the sum of two phases.
fn times<K: Clone + Ord>(a: &Sparse<K>, b: &Sparse<K>) -> Sparse<K> {
    let mut product = a.clone();
    b.iter().for_each(|(key, exponent)| put(&mut product, key.clone(), exponent.clone()));
    product
}

fn over(a: &Powers, b: &Powers) -> Powers {
    let mut quotient = a.clone();
    b.iter().for_each(|(key, exponent)| put(&mut quotient, *key, -exponent.clone()));
    quotient
}

fn shifted(term: &Term, shift: &Powers) -> Term {
    Term { powers: times(&term.powers, shift), ..term.clone() }
}

/// A number that is written as one.
fn fraction(formula: &Formula) -> Option<Rational> {
    match formula {
        Formula::Number(value) => Some(value.clone()),
        Formula::Negate(operand) => Some(-fraction(operand)?),
        Formula::Fraction(over, under) => fraction(over)?.checked_div(&fraction(under)?),
        _ => None,
    }
}

/// A power: of a sum if the exponent is a small natural number, otherwise of a product of powers.
fn raised(base: &Terms, exponent: &Rational) -> Option<Terms> {
    if let Some(n) = exponent.to_natural().filter(|&n| n <= HIGHEST_POWER) {
        return (0..n).try_fold(constant(Rational::from(1)), |power, _| multiplied(&power, base));
    }
    let (Term { powers, phase, is_odd }, value) = base.first().filter(|_| base.len() == 1)?;
    if !phase.is_empty() || *is_odd {
        return None;
    }
    let doubled = exponent.clone() + exponent.clone();
    let n = isize::try_from(doubled.magnitude().to_natural().filter(|&n| n <= HIGHEST_POWER)?).ok()?;
    let n = if exponent.is_negative() { -n } else { n };
    let value =
        if n % 2 == 0 { value.integer_power(n / 2)? } else { value.square_root()?.integer_power(n)? };
    let powers = powers.iter().map(|(key, power)| (*key, power.clone() * exponent.clone())).collect();
    Some(vec![(Term { powers, ..Term::default() }, value)])
}

/// The cosine or the sine of a phase, by exponentials.
fn wave(phase: &Terms, is_odd: bool) -> Option<Terms> {
    if phase.iter().any(|(term, _)| !term.phase.is_empty() || term.is_odd) {
        return None;
    }
    let mut sum = Terms::new();
    for sign in [1, -1] {
        let signed = |value: &Rational| value.clone() * Rational::from(sign);
        let phase = phase.iter().map(|(term, value)| (term.powers.clone(), signed(value))).collect();
        // −i/2 of the exponential itself, i/2 of its conjugate.
        let half = Rational::new(if is_odd { -sign } else { 1 }, 2)?;
        put(&mut sum, Term { powers: Powers::new(), phase, is_odd }, half);
    }
    Some(sum)
}
