//! Equations of motion and polynomials as formulas.

use super::{Formula, Name, number, scaled, sum};
use libration::algebra::{Polynomial, Variable};
use libration::expression::{Expression, Symbol, greek_letter};

impl From<&Expression> for Formula {
    fn from(expression: &Expression) -> Self {
        let of = |part: &Expression| Self::from(part);
        match expression {
            Expression::Number(value) => Self::Number(value.clone()),
            Expression::Pi => Self::Pi,
            Expression::Symbol(symbol) => Self::Name(symbol.into()),
            Expression::Negate(a) => -of(a),
            Expression::Add(a, b) => of(a) + of(b),
            Expression::Subtract(a, b) => of(a) - of(b),
            Expression::Multiply(a, b) => of(a) * of(b),
            Expression::Divide(a, b) => of(a) / of(b),
            Expression::Power(a, b) => of(a).pow(of(b)),
            Expression::Call(function, a) => Self::Call(*function, Box::new(of(a))),
        }
    }
}

impl From<&Symbol> for Name {
    /// Converts what follows a line, or digits at the end, to a subscript, and names of Greek letters to the letters.
    fn from(symbol: &Symbol) -> Self {
        let word = symbol.name.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let (word, below) = symbol.name.split_once('_').unwrap_or_else(|| symbol.name.split_at(word.len()));
        let letter = greek_letter(word).map_or_else(|| word.to_owned(), String::from);
        let name = match below.parse::<i64>() {
            _ if below.is_empty() => Self::new(&letter),
            Ok(index) if index.to_string() == below => Self::new(&letter).index(index),
            _ => Self::new(&letter).word(below),
        };
        (0..symbol.primes).fold(name, |name, _| name.prime())
    }
}

impl From<&Polynomial> for Formula {
    fn from(polynomial: &Polynomial) -> Self {
        let terms = polynomial.terms().map(|(monomial, coefficient)| {
            let factors: Vec<Self> =
                monomial.factors().iter().map(|(variable, n)| power(variable, *n)).collect();
            match factors.into_iter().reduce(|product, factor| product * factor) {
                None => Self::Number(coefficient.clone()),
                Some(product) => scaled(coefficient, product),
            }
        });
        let terms: Vec<Self> = terms.collect();
        if terms.is_empty() { number(0) } else { sum(terms) }
    }
}

fn power(variable: &Variable, exponent: u32) -> Formula {
    let base = Formula::Name(variable.into());
    if exponent == 1 { base } else { base.pow(i64::from(exponent)) }
}

impl From<&Variable> for Name {
    fn from(variable: &Variable) -> Self {
        let name = Self::new(variable.letters());
        match variable.index() {
            Some(index) => name.index(i64::from(index)),
            None => name,
        }
    }
}
