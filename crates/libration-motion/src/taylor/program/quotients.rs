//! Quotients whose numerator and denominator vanish together: x′/√|x′| is √|x′|·sign(x′), which has a value at zero.

use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Expression, Function};

/// The formula with u^k/|u|^p replaced by |u|^(k−p)·sign(u) for odd k ≥ p, and by |u|^(k−p) for even k.
pub(super) fn with_value_at_zero(formula: &Expression) -> Expression {
    let mut product = Product::of(formula);
    let Some(power) = product.joined() else { return formula.with_parts(with_value_at_zero) };
    let rest = product.factors.iter();
    let whole = rest.fold(power, |whole, (base, exponent)| times(whole, with_value_at_zero(base), exponent));
    if product.is_negative { Expression::Negate(Box::new(whole)) } else { whole }
}

/// The sign and the factors of a product or a quotient.
#[derive(Default)]
pub(super) struct Product<'a> {
    pub(super) is_negative: bool,
    /// Bases with their exponents.
    pub(super) factors: Vec<(&'a Expression, Rational)>,
}

impl<'a> Product<'a> {
    pub(super) fn of(formula: &'a Expression) -> Self {
        let mut product = Self::default();
        product.collect(formula, &Rational::from(1));
        product
    }

    fn collect(&mut self, formula: &'a Expression, exponent: &Rational) {
        match formula {
            Expression::Negate(a) => {
                self.is_negative ^= is_odd(exponent);
                self.collect(a, exponent);
            }
            Expression::Multiply(a, b) => {
                self.collect(a, exponent);
                self.collect(b, exponent);
            }
            Expression::Divide(a, b) => {
                self.collect(a, exponent);
                self.collect(b, &Rationals.negate(exponent));
            }
            Expression::Call(Function::Sqrt, base) if is_modulus(base) => {
                self.multiply(base, Rationals.over_integer(exponent, 2).expect("fractions have halves"));
            }
            Expression::Power(base, power) => match power.to_rational() {
                Some(power) if is_modulus(base) => self.multiply(base, Rationals.multiply(exponent, &power)),
                Some(power) if power.is_integer() => {
                    self.collect(base, &Rationals.multiply(exponent, &power));
                }
                _ => self.multiply(formula, exponent.clone()),
            },
            _ => self.multiply(formula, exponent.clone()),
        }
    }

    fn multiply(&mut self, base: &'a Expression, exponent: Rational) {
        match self.factors.iter_mut().find(|(other, _)| *other == base) {
            Some((_, sum)) => *sum = Rationals.add(sum, &exponent),
            None => self.factors.push((base, exponent)),
        }
    }

    /// u^k/|u|^p as a single power, which is removed from the factors.
    fn joined(&mut self) -> Option<Expression> {
        let divisors = self.factors.iter().filter(|(_, exponent)| exponent.is_negative());
        let (modulus, u, left, is_odd) = divisors.into_iter().find_map(|(base, divided)| {
            let Expression::Call(Function::Abs, u) = base else { return None };
            let (_, times) = self.factors.iter().find(|(other, _)| **other == **u)?;
            let left = Rationals.add(times, divided);
            (times.is_integer() && !left.is_negative()).then(|| (*base, &**u, left, is_odd(times)))
        })?;
        self.factors.retain(|(base, _)| *base != modulus && *base != u);
        let sign = Expression::Call(Function::Sign, Box::new(u.clone()));
        Some(times(if is_odd { sign } else { Expression::from(1) }, modulus.clone(), &left))
    }
}

fn is_modulus(formula: &Expression) -> bool {
    matches!(formula, Expression::Call(Function::Abs, _))
}

fn is_odd(integer: &Rational) -> bool {
    Rationals.over_integer(integer, 2).is_some_and(|half| !half.is_integer())
}

/// A product with one more factor.
fn times(product: Expression, base: Expression, exponent: &Rational) -> Expression {
    let one = Rational::from(1);
    let size = if exponent.is_negative() { Rationals.negate(exponent) } else { exponent.clone() };
    let power = match () {
        () if size.is_zero() => return product,
        () if size == one => base,
        () => Expression::Power(Box::new(base), Box::new(Expression::Number(size))),
    };
    let operation = if exponent.is_negative() { Expression::Divide } else { Expression::Multiply };
    operation(Box::new(product), Box::new(power))
}
