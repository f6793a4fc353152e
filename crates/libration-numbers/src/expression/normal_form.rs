//! Formulas as quotients of polynomials in which equal formulas look alike; this proves that a formula vanishes, and gives degrees and
//! coefficients.
//!
//! The indeterminates are symbols, π, function values and powers with other than natural exponents, all treated as independent; signs are taken
//! out of even and odd functions. So sin(-x) + sin(x) is recognised as zero, sin² + cos² − 1 is not.

use super::{Expression, Function, Symbol};
use crate::algebra::{Parity, Polynomial, Rational};

/// Work limit for one formula: products of two terms, with more weight for long coefficients.
const MOST_WORK: usize = 1 << 16;

/// Indeterminate of the polynomials.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Atom {
    Pi,
    Symbol(Symbol),
    Call(Function, Box<NormalForm>),
    Power(Box<NormalForm>, Box<NormalForm>),
}

impl Atom {
    fn contains_any(&self, symbols: &[Symbol]) -> bool {
        match self {
            Self::Pi => false,
            Self::Symbol(symbol) => symbols.contains(symbol),
            Self::Call(_, a) => a.contains_any(symbols),
            Self::Power(a, b) => a.contains_any(symbols) || b.contains_any(symbols),
        }
    }
}

/// A quotient of two polynomials; the leading coefficient of the denominator is one. Common factors are not cancelled.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct NormalForm {
    upper: Polynomial<Atom>,
    lower: Polynomial<Atom>,
}

impl Expression {
    /// Returns `true` if the formula is proved to be zero everywhere.
    #[doc(hidden)]
    pub fn vanishes(&self) -> bool {
        NormalForm::from_tree(self).is_some_and(|form| form.upper.is_zero())
    }

    /// The total degree in these symbols, if the formula is a polynomial in them as written: products are expanded, but common factors of
    /// fractions are not cancelled. `None` for other formulas, and for polynomials with too many terms.
    #[must_use]
    pub fn polynomial_degree(&self, symbols: &[Symbol]) -> Option<u32> {
        let form = NormalForm::from_tree(self)?;
        let is_symbol = |atom: &Atom| matches!(atom, Atom::Symbol(symbol) if symbols.contains(symbol));
        let hidden = |atom: &Atom| !is_symbol(atom) && atom.contains_any(symbols);
        let polynomial = !form.lower.has(|atom| atom.contains_any(symbols)) && !form.upper.has(hidden);
        polynomial.then(|| form.upper.degree_in_kind(is_symbol))
    }

    /// The coefficients, constant term first, of a polynomial in one symbol with rational coefficients.
    #[doc(hidden)]
    pub fn polynomial_coefficients(&self, symbol: &Symbol) -> Option<Vec<Rational>> {
        let form = NormalForm::from_tree(self)?;
        let only = |polynomial: &Polynomial<Atom>| polynomial.coefficients_in(&Atom::Symbol(symbol.clone()));
        if form.lower != Polynomial::from_number(Rational::from(1)) { None } else { only(&form.upper) }
    }
}

impl NormalForm {
    fn from_tree(tree: &Expression) -> Option<Self> {
        Expansion { work: MOST_WORK }.form(tree)
    }

    fn polynomial(upper: Polynomial<Atom>) -> Self {
        Self { upper, lower: Polynomial::from_number(Rational::from(1)) }
    }

    fn contains_any(&self, symbols: &[Symbol]) -> bool {
        [&self.upper, &self.lower].iter().any(|part| part.has(|atom| atom.contains_any(symbols)))
    }

    fn negated(&self) -> Self {
        Self { upper: -self.upper.clone(), lower: self.lower.clone() }
    }

    /// The value, if the form is a constant.
    fn number(&self) -> Option<Rational> {
        (self.lower == Polynomial::from_number(Rational::from(1))).then(|| self.upper.to_constant()).flatten()
    }
}

/// The conversion of a tree into its normal form, with the remaining work limit.
struct Expansion {
    work: usize,
}

impl Expansion {
    fn form(&mut self, tree: &Expression) -> Option<NormalForm> {
        match tree {
            Expression::Number(value) => Some(NormalForm::polynomial(Polynomial::from_number(value.clone()))),
            Expression::Pi => Some(NormalForm::polynomial(Polynomial::from_variable(Atom::Pi))),
            Expression::Symbol(symbol) => {
                Some(NormalForm::polynomial(Polynomial::from_variable(Atom::Symbol(symbol.clone()))))
            }
            Expression::Negate(a) => Some(self.form(a)?.negated()),
            Expression::Add(a, b) => {
                let (a, b) = (self.form(a)?, self.form(b)?);
                self.sum(&a, &b)
            }
            Expression::Subtract(a, b) => {
                let (a, b) = (self.form(a)?, self.form(b)?.negated());
                self.sum(&a, &b)
            }
            Expression::Multiply(a, b) => {
                let (a, b) = (self.form(a)?, self.form(b)?);
                self.product(&a, &b)
            }
            Expression::Divide(a, b) => {
                let (a, b) = (self.form(a)?, self.form(b)?);
                self.product(&a, &reciprocal(&b)?)
            }
            Expression::Power(a, b) => {
                let (a, b) = (self.form(a)?, self.form(b)?);
                self.power(a, b)
            }
            Expression::Call(function, a) => Some(value_of(*function, self.form(a)?)),
        }
    }

    fn times(&mut self, a: &Polynomial<Atom>, b: &Polynomial<Atom>) -> Option<Polynomial<Atom>> {
        self.work = self.work.checked_sub(a.cost().saturating_mul(b.cost()))?;
        a.checked_times(b)
    }

    fn sum(&mut self, a: &NormalForm, b: &NormalForm) -> Option<NormalForm> {
        self.work = self.work.checked_sub(a.upper.cost() + b.upper.cost())?;
        if a.lower == b.lower {
            return Some(NormalForm { upper: a.upper.plus(&b.upper), lower: a.lower.clone() });
        }
        let upper = self.times(&a.upper, &b.lower)?.plus(&self.times(&b.upper, &a.lower)?);
        Some(NormalForm { upper, lower: self.times(&a.lower, &b.lower)? })
    }

    fn product(&mut self, a: &NormalForm, b: &NormalForm) -> Option<NormalForm> {
        Some(NormalForm { upper: self.times(&a.upper, &b.upper)?, lower: self.times(&a.lower, &b.lower)? })
    }

    fn power(&mut self, base: NormalForm, exponent: NormalForm) -> Option<NormalForm> {
        let Some(number) = exponent.number().filter(Rational::is_integer) else {
            let atom = Atom::Power(Box::new(base), Box::new(exponent));
            return Some(NormalForm::polynomial(Polynomial::from_variable(atom)));
        };
        let base = if number.is_negative() { reciprocal(&base)? } else { base };
        let times = u32::try_from(number.magnitude().to_natural()?).ok()?;
        let (upper, lower) =
            (self.natural_power(&base.upper, times)?, self.natural_power(&base.lower, times)?);
        Some(NormalForm { upper, lower })
    }

    fn natural_power(&mut self, base: &Polynomial<Atom>, times: u32) -> Option<Polynomial<Atom>> {
        if let Some(power) = base.power_of_one_term(times) {
            return power;
        }
        let mut power = Polynomial::from_number(Rational::from(1));
        for _ in 0..times {
            power = self.times(&power, base)?;
        }
        Some(power)
    }
}

/// The inverse; `None` for zero.
fn reciprocal(form: &NormalForm) -> Option<NormalForm> {
    let scale = Rational::from(1).checked_div(form.upper.leading()?)?;
    Some(NormalForm { upper: form.lower.scaled(&scale), lower: form.upper.scaled(&scale) })
}

/// f(a) as an atom, with the sign of a taken out if f is even or odd.
fn value_of(function: Function, argument: NormalForm) -> NormalForm {
    let negative = argument.upper.leading().is_some_and(Rational::is_negative);
    let (argument, odd) = match function.parity() {
        Some(parity) if negative => (argument.negated(), parity == Parity::Odd),
        _ => (argument, false),
    };
    let value = NormalForm::polynomial(Polynomial::from_variable(Atom::Call(function, Box::new(argument))));
    if odd { value.negated() } else { value }
}
