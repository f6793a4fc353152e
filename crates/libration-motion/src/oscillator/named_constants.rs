//! Names for constants that are not products of symbolic parameters, such as √2, π and eᵏ.
//!
//! # Method
//! In expansions with symbolic parameters, constants that no product of symbols equals (√2, e^k, long powers of sums) get names and are then
//! symbols too.

use libration_numbers::algebra::{LaurentPolynomial, LaurentPolynomials, Rational};
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// A formula of variables and symbolic parameters, whose constants are products of these, or are replaced by names.
pub(super) struct NamedConstants<'a> {
    variables: &'a [Symbol],
    ring: LaurentPolynomials,
    taken: Vec<String>,
    /// The names with the constants that they replace.
    pub(super) constants: Vec<(String, Expression)>,
}

impl<'a> NamedConstants<'a> {
    pub(super) fn new(variables: &'a [Symbol], letters: &[String]) -> Self {
        let ring = LaurentPolynomials::new(letters.to_vec());
        Self { variables, ring, taken: letters.to_vec(), constants: vec![] }
    }

    /// The formula with names for constants. Sums, products and powers of constants are kept, so that few names are needed.
    pub(super) fn named(&mut self, formula: &Expression) -> Expression {
        let is_constant = !self.variables.iter().any(|variable| formula.contains(variable));
        if is_constant && value_of(&self.ring, formula).is_some() {
            return formula.clone();
        }
        let two = |one: &Expression, other: &Expression, names: &mut Self| {
            (Box::new(names.named(one)), Box::new(names.named(other)))
        };
        match formula {
            Expression::Negate(a) => Expression::Negate(Box::new(self.named(a))),
            Expression::Add(a, b) => {
                let (a, b) = two(a, b, self);
                Expression::Add(a, b)
            }
            Expression::Subtract(a, b) => {
                let (a, b) = two(a, b, self);
                Expression::Subtract(a, b)
            }
            Expression::Multiply(a, b) => {
                let (a, b) = two(a, b, self);
                Expression::Multiply(a, b)
            }
            Expression::Divide(a, b) if !is_constant || !is_sum(b) => {
                let (a, b) = two(a, b, self);
                Expression::Divide(a, b)
            }
            Expression::Power(a, b) if !is_constant || (is_natural(b) && !is_sum(a)) => {
                let (a, b) = two(a, b, self);
                Expression::Power(a, b)
            }
            Expression::Call(function, a) if !is_constant => {
                Expression::Call(*function, Box::new(self.named(a)))
            }
            Expression::Symbol(_) | Expression::Number(_) => formula.clone(),
            _ => self.name(formula),
        }
    }

    fn name(&mut self, constant: &Expression) -> Expression {
        if let Some((name, _)) = self.constants.iter().find(|(_, other)| other == constant) {
            return Expression::symbol(name);
        }
        let first = if *constant == Expression::Pi {
            "pi".to_owned()
        } else {
            format!("c{}", self.constants.len() + 1)
        };
        let name = free_name(&first, &self.taken);
        self.taken.push(name.clone());
        self.constants.push((name.clone(), constant.clone()));
        Expression::Symbol(Symbol::plain(&name))
    }
}

fn is_natural(exponent: &Expression) -> bool {
    exponent.to_rational().is_some_and(|value: Rational| value.to_natural().is_some())
}

fn is_sum(formula: &Expression) -> bool {
    matches!(formula, Expression::Add(..) | Expression::Subtract(..))
}

/// A formula of the symbols as an element of the ring.
pub(super) fn value_of(ring: &LaurentPolynomials, formula: &Expression) -> Option<LaurentPolynomial> {
    let letters: Vec<Symbol> = ring.letters().iter().map(|name| Symbol::plain(name)).collect();
    let tape = Tape::new(&[formula], &letters).ok()?;
    let inputs: Vec<LaurentPolynomial> = (0..letters.len()).map(|number| ring.letter(number)).collect();
    let value = Jet::new(ring, &tape, &inputs).ok()?.result(0)[0].clone();
    (!value.is_beyond_limit()).then_some(value)
}

/// The name itself, or one derived from it, that is not in use.
pub(super) fn free_name(name: &str, others: &[String]) -> String {
    let mut free = name.to_owned();
    while others.contains(&free) {
        free.push('_');
    }
    free
}
