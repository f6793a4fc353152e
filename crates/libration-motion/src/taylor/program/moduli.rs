//! Absolute values as products with a sign, which is constant during a step; and signs.

use libration_numbers::algebra::Rational;
use libration_numbers::expression::{Expression, Function, Symbol};

/// The arguments of the absolute values and signs found so far, each once.
#[derive(Debug, Default)]
pub(in crate::taylor) struct Moduli {
    arguments: Vec<Modulus>,
    /// Bases without |…| of powers that are not integers.
    bases: Vec<Expression>,
}

/// The argument of a |…| or a sign.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Modulus {
    /// The argument with all |…| within it replaced by products with signs.
    pub(in crate::taylor) argument: Expression,
    /// The argument in its original form.
    pub(in crate::taylor) written: Expression,
    /// `true` if an expression that vanishes with the argument has a power that is not an integer, and no series there.
    pub(in crate::taylor) in_root: bool,
    /// `true` if a divisor vanishes with the argument and its dividend does not, so that a rate of change is infinite there.
    pub(in crate::taylor) divides: bool,
}

impl Moduli {
    /// The formula with each |u| replaced by s·u, and sign(u) by s.
    pub(in crate::taylor) fn taken_out(&mut self, formula: &Expression) -> Expression {
        match formula {
            Expression::Call(Function::Abs, a) => {
                let argument = self.taken_out(a);
                Expression::Multiply(Box::new(self.sign_of(&argument, a)), Box::new(argument))
            }
            Expression::Call(Function::Sign, a) => {
                let argument = self.taken_out(a);
                self.sign_of(&argument, a)
            }
            Expression::Call(Function::Sqrt, base) if let Some(size) = root_of_square(base) => {
                self.taken_out(&size)
            }
            Expression::Call(Function::Sqrt, base) => {
                self.root(base, |base| Expression::Call(Function::Sqrt, Box::new(base)))
            }
            Expression::Power(base, exponent) => match broken(exponent) {
                Some(exponent) => self.root(base, |base| {
                    Expression::Power(Box::new(base), Box::new(Expression::Number(exponent)))
                }),
                None => {
                    let base = self.taken_out(base);
                    if exponent.to_f64().is_some_and(|exponent| exponent < 0.0) {
                        self.divide(&Expression::from(1), &base);
                    }
                    Expression::Power(Box::new(base), exponent.clone())
                }
            },
            Expression::Divide(dividend, divisor) => {
                let [dividend, divisor] = [dividend, divisor].map(|part| self.taken_out(part));
                self.divide(&dividend, &divisor);
                Expression::Divide(Box::new(dividend), Box::new(divisor))
            }
            _ => formula.with_parts(|part| self.taken_out(part)),
        }
    }

    /// Notes the arguments with which the divisor of a quotient vanishes, but not the dividend.
    fn divide(&mut self, dividend: &Expression, divisor: &Expression) {
        for Modulus { argument, divides, .. } in &mut self.arguments {
            let vanishes = |part: &Expression| roots_of_zero(&with_zero(part, argument)).vanishes();
            *divides |= vanishes(divisor) && !vanishes(dividend);
        }
    }

    /// A power that is not an integer. A base that vanishes for one value of a sign, as (x + |x|)/2 does, is replaced by one there, and the
    /// power is multiplied by zero: so it has a series for either value.
    fn root(&mut self, base: &Expression, power: impl FnOnce(Expression) -> Expression) -> Expression {
        let base = self.taken_out(base);
        let within: Vec<usize> =
            (0..self.arguments.len()).filter(|&index| base.contains(&sign(index))).collect();
        for &index in &within {
            let Modulus { argument, in_root, .. } = &mut self.arguments[index];
            *in_root |= with_zero(&base, argument).vanishes();
        }
        if within.is_empty() {
            self.bases.push(base.clone());
        }
        let [index] = within[..] else { return power(base) };
        let vanishes = |side: i64| base.substitute(&sign(index), &Expression::from(side)).vanishes();
        let half_less = |side: Expression| {
            let sum = Expression::Subtract(Box::new(Expression::from(1)), Box::new(side));
            Expression::Divide(Box::new(sum), Box::new(Expression::from(2)))
        };
        let itself = || Expression::Symbol(sign(index));
        let (there, elsewhere) = match [vanishes(-1), vanishes(1)] {
            [true, false] => (itself(), Expression::Negate(Box::new(itself()))),
            [false, true] => (Expression::Negate(Box::new(itself())), itself()),
            _ => return power(base),
        };
        let base = Expression::Add(Box::new(base), Box::new(half_less(there)));
        Expression::Multiply(Box::new(half_less(elsewhere)), Box::new(power(base)))
    }

    /// The sign of an argument, as a symbol.
    fn sign_of(&mut self, argument: &Expression, written: &Expression) -> Expression {
        let existing = self.arguments.iter().position(|other| other.argument == *argument);
        let index = existing.unwrap_or_else(|| {
            let (argument, written) = (argument.clone(), written.clone());
            self.arguments.push(Modulus { argument, written, in_root: false, divides: false });
            self.arguments.len() - 1
        });
        Expression::Symbol(sign(index))
    }

    /// The symbols that stand for the signs.
    pub(in crate::taylor) fn signs(&self) -> impl Iterator<Item = Symbol> {
        (0..self.arguments.len()).map(sign)
    }

    /// The argument at whose zero a formula jumps, after these signs were taken out of it; `None` if it does not jump.
    pub(in crate::taylor) fn jump_in(&self, formula: &Expression) -> Option<String> {
        let jumping = (0..self.arguments.len()).find(|&index| self.jumps(index, formula))?;
        Some(self.arguments[jumping].written.to_string())
    }

    /// Returns `true` if a formula, out of which these signs were taken, jumps where an argument is zero.
    pub(in crate::taylor) fn jumps(&self, index: usize, formula: &Expression) -> bool {
        let side = |side: i64| formula.substitute(&sign(index), &Expression::from(side));
        let both = Expression::Subtract(Box::new(side(1)), Box::new(side(-1)));
        let there = roots_of_zero(&with_zero(&both, &self.arguments[index].argument));
        !there.vanishes()
    }

    /// Returns `true` if a power that is not an integer is taken of a symbol itself, and has no value on one side of its zero.
    pub(in crate::taylor) fn has_power_of(&self, symbol: &Symbol) -> bool {
        self.bases.contains(&Expression::Symbol(symbol.clone()))
    }

    pub(in crate::taylor) fn into_arguments(self) -> Vec<Modulus> {
        self.arguments
    }
}

/// The square root of an even power, which has a kink at its zero as |u| has.
pub(in crate::taylor) fn root_of_square(base: &Expression) -> Option<Expression> {
    let size = |of: &Expression| Expression::Call(Function::Abs, Box::new(of.clone()));
    match base {
        Expression::Multiply(a, b) if a == b => Some(size(a)),
        Expression::Power(of, exponent) => {
            let half = exponent.to_rational()?.divided_by_power_of_two(1);
            (half.is_integer() && !half.is_negative()).then(|| {
                Expression::Power(Box::new(size(of)), Box::new(Expression::Number(half))).simplified()
            })
        }
        _ => None,
    }
}

/// The exponent, if it is a positive number that is not an integer.
fn broken(exponent: &Expression) -> Option<Rational> {
    // The shortest decimal of a number can be parsed as a formula.
    let nearest = || format!("{:?}", exponent.to_f64()?).parse::<Expression>().ok()?.to_rational();
    let number = exponent.to_rational().or_else(nearest)?;
    (!number.is_integer() && !number.is_negative()).then_some(number)
}

/// The formula with a part replaced by zero.
fn with_zero(formula: &Expression, part: &Expression) -> Expression {
    if formula == part { Expression::from(0) } else { formula.with_parts(|inner| with_zero(inner, part)) }
}

/// The formula with a symbol, and roots of it, replaced by zero.
pub(in crate::taylor) fn where_zero(formula: &Expression, symbol: &Symbol) -> Expression {
    roots_of_zero(&formula.substitute(symbol, &Expression::from(0)).simplified()).simplified()
}

/// The formula with roots and powers of zero replaced by zero.
fn roots_of_zero(formula: &Expression) -> Expression {
    match formula {
        Expression::Call(Function::Sqrt, base) if roots_of_zero(base).vanishes() => Expression::from(0),
        Expression::Power(base, exponent) if broken(exponent).is_some() && roots_of_zero(base).vanishes() => {
            Expression::from(0)
        }
        _ => formula.with_parts(roots_of_zero),
    }
}

/// The symbol of a sign, with a name that cannot occur in a text.
fn sign(index: usize) -> Symbol {
    Symbol::plain(&format!("sign of |{index}|"))
}
