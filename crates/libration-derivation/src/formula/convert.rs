//! Equations of motion and polynomials as formulas.

use super::{Formula, Name, number, scaled, sqrt, sum};
use libration::algebra::{LaurentPolynomial, LetterPower, Polynomial, Rational, Variable};
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
            Expression::Divide(a, b) => match of(a) {
                Self::Fraction(over, under) => *over / (*under * of(b)),
                over => over / of(b),
            },
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

/// A sum of products of letters and their inverses and roots, in which `of` stands for each letter.
pub(crate) fn laurent(sum_of: &LaurentPolynomial, of: &dyn Fn(&str) -> Formula) -> Formula {
    let term = |(factor, powers): (&Rational, Vec<LetterPower<'_>>)| {
        let is_above = |power: &&LetterPower<'_>| !power.exponent.is_negative();
        let written = |power: &LetterPower<'_>| of_letter(of(power.letter), &power.exponent.magnitude());
        let above: Vec<Formula> = powers.iter().filter(is_above).flat_map(written).collect();
        let below: Vec<Formula> = powers.iter().filter(|power| !is_above(power)).flat_map(written).collect();
        let size = factor.magnitude();
        let [over, under] =
            [size.numerator(), size.denominator()].map(|digits| digits.parse::<Rational>().ok());
        let one = Some(Rational::from(1));
        let with = |number: Option<Rational>, letters: Vec<Formula>, number_alone: bool| {
            let number =
                number.filter(|number| Some(number) != one.as_ref() || letters.is_empty() && number_alone);
            number.into_iter().map(Formula::Number).chain(letters).collect::<Vec<_>>()
        };
        let term = if below.is_empty() {
            product(with(Some(size), above, true))
        } else {
            product(with(over, above, true)) / product(with(under, below, true))
        };
        if factor.is_negative() { -term } else { term }
    };
    let terms: Vec<Formula> = sum_of.terms().map(term).collect();
    if terms.is_empty() { number(0) } else { sum(terms) }
}

/// A power of a letter, with a root for half of an exponent.
fn of_letter(letter: Formula, exponent: &Rational) -> Vec<Formula> {
    let doubled = (exponent.clone() + exponent.clone()).numerator().parse::<i64>().unwrap_or(0);
    let whole = match doubled / 2 {
        0 => None,
        1 => Some(letter.clone()),
        n => Some(letter.clone().pow(n)),
    };
    whole.into_iter().chain((doubled % 2 == 1).then(|| sqrt(letter))).collect()
}

fn product(factors: Vec<Formula>) -> Formula {
    factors.into_iter().reduce(|product, factor| product * factor).unwrap_or_else(|| number(1))
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
