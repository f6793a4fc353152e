//! A formula evaluated in any ring: numbers, series, polynomials.

use libration::algebra::{Rational, Ring};
use libration::expression::{Expression, Symbol};

/// The values of the symbols of a formula, by name (`theta0`, `theta''`).
pub(super) type PrintedValues<'a, E> = &'a dyn Fn(&str) -> Option<E>;

/// The value of the formula; `None` if a symbol has no value, or an operation does not exist in the ring.
pub(super) fn value<R: Ring>(
    ring: &R,
    formula: &Expression,
    of: PrintedValues<'_, R::Element>,
) -> Option<R::Element> {
    let operands = |a: &Expression, b: &Expression| Some((value(ring, a, of)?, value(ring, b, of)?));
    match formula {
        Expression::Number(number) => ring.rational(number),
        Expression::Pi => ring.pi(),
        Expression::Symbol(symbol) => of(&written(symbol)),
        Expression::Negate(a) => Some(ring.negate(&value(ring, a, of)?)),
        Expression::Add(a, b) => operands(a, b).map(|(a, b)| ring.add(&a, &b)),
        Expression::Subtract(a, b) => operands(a, b).map(|(a, b)| ring.subtract(&a, &b)),
        Expression::Multiply(a, b) => operands(a, b).map(|(a, b)| ring.multiply(&a, &b)),
        Expression::Divide(a, b) => operands(a, b).and_then(|(a, b)| ring.divide(&a, &b)),
        Expression::Power(a, exponent) => power(ring, &value(ring, a, of)?, &exponent.to_rational()?),
        Expression::Call(function, a) => ring.value(*function, &value(ring, a, of)?),
    }
}

/// The name of a symbol with its primes.
pub(super) fn written(symbol: &Symbol) -> String {
    format!("{}{}", symbol.name, "'".repeat(usize::from(symbol.primes)))
}

/// Natural powers by multiplication, so that any base is allowed.
fn power<R: Ring>(ring: &R, base: &R::Element, exponent: &Rational) -> Option<R::Element> {
    match exponent.to_string().parse::<u32>() {
        Ok(natural) => {
            let one = ring.rational(&Rational::from(1))?;
            Some((0..natural).fold(one, |product, _| ring.multiply(&product, base)))
        }
        Err(_) => ring.power(base, exponent),
    }
}
