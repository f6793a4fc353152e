//! The acceleration of one variable as a function of position and velocity: its values and symmetries.

use libration_numbers::algebra::{BigFloat, Doubles, Floats, Rational, Rationals, Ring};
use libration_numbers::{
    expression::{Expression, Symbol},
    internals::expression::{Jet, Tape},
};

use super::constant::{Approximation, Constant, PRECISION};

/// Number of bits to which a number must agree with a fraction to be recognised as that fraction.
pub(super) const RECOGNISED_BITS: usize = 400;

/// An acceleration F(x, x′).
#[derive(Clone, Debug)]
pub(super) struct Force {
    pub(super) formula: Expression,
    pub(super) x: Symbol,
    pub(super) velocity: Symbol,
}

impl Force {
    pub(super) fn new(formula: Expression, variable: &str) -> Self {
        let x = Symbol::plain(variable);
        let velocity = x.with_primes(1);
        Self { formula, x, velocity }
    }

    /// F(x, 0).
    pub(super) fn at_rest(&self) -> Expression {
        self.formula.substitute(&self.velocity, &Expression::from(0)).simplified()
    }

    /// −∂F/∂x at rest.
    pub(super) fn stiffness(&self) -> Expression {
        let slope = self.at_rest().derivative(&self.x);
        Expression::Negate(Box::new(slope)).simplified()
    }

    /// ∂F/∂x′ at rest.
    pub(super) fn damping(&self) -> Expression {
        let slope = self.formula.derivative(&self.velocity);
        slope.substitute(&self.velocity, &Expression::from(0)).simplified()
    }

    /// Returns `true` unless F(x, x′) = F(x, 0) is proved. The derivative does not decide this: that of sign(x′) is zero on either side.
    pub(super) fn uses_velocity(&self) -> bool {
        self.formula.contains(&self.velocity) && !difference(self.formula.clone(), self.at_rest()).vanishes()
    }

    /// Returns `true` if F(x, −x′) = F(x, x′) is proved.
    pub(super) fn is_reversible(&self) -> bool {
        // A formula too long for a comparison of its terms may still be free of the velocity.
        !self.formula.contains(&self.velocity)
            || difference(reflected(&self.formula, &self.velocity, None), self.formula.clone()).vanishes()
    }

    /// Returns `true` if F is proved to be the opposite at the mirror image of a position, with the same velocity.
    pub(super) fn is_mirrored_about(&self, position: &Rational) -> bool {
        let other_side = reflected(&self.formula, &self.x, Some(position));
        Expression::Add(Box::new(other_side), Box::new(self.formula.clone())).vanishes()
    }

    /// Returns `true` if F is proved to be the opposite at the mirror image of a position, with the opposite velocity.
    pub(super) fn is_odd_about(&self, position: &Rational) -> bool {
        let other_side = reflected(&self.formula, &self.x, Some(position));
        let other_side = reflected(&other_side, &self.velocity, None);
        Expression::Add(Box::new(other_side), Box::new(self.formula.clone())).vanishes()
    }

    /// Returns `true` if F is proved to be unchanged by a change of sign of both velocity and parameter.
    pub(super) fn is_reversible_with(&self, parameter: &Symbol) -> bool {
        let backwards = reflected(&reflected(&self.formula, &self.velocity, None), parameter, None);
        difference(backwards, self.formula.clone()).vanishes()
    }
}

/// A formula with the symbol u replaced by 2a − u, or by −u if there is no a.
fn reflected(formula: &Expression, symbol: &Symbol, about: Option<&Rational>) -> Expression {
    let variable = Expression::Symbol(symbol.clone());
    let twice = about.map(|centre| Rationals.times_integer(centre, 2)).filter(|twice| !twice.is_zero());
    let by = match twice {
        Some(twice) => difference(Expression::Number(twice), variable),
        None => Expression::Negate(Box::new(variable)),
    };
    formula.substitute(symbol, &by)
}

fn difference(a: Expression, b: Expression) -> Expression {
    Expression::Subtract(Box::new(a), Box::new(b))
}

/// A formula of one symbol, prepared for evaluation.
pub(super) struct Curve<'a> {
    formula: &'a Expression,
    x: &'a Symbol,
    tape: Tape,
}

impl<'a> Curve<'a> {
    /// The curve; `None` if other symbols occur.
    pub(super) fn new(formula: &'a Expression, x: &'a Symbol) -> Option<Self> {
        let tape = Tape::new(&[formula], std::slice::from_ref(x)).ok()?;
        Some(Self { formula, x, tape })
    }

    fn value<R: Ring>(&self, ring: &R, at: R::Element) -> Option<R::Element> {
        Some(Jet::new(ring, &self.tape, &[at]).ok()?.result(0)[0].clone())
    }

    /// The value; NaN if there is none.
    pub(super) fn at(&self, x: f64) -> f64 {
        self.value(&Doubles, x).unwrap_or(f64::NAN)
    }

    /// Returns `true` if the function has a first Taylor coefficient at a number; |x| has none at zero.
    pub(super) fn is_smooth_at(&self, x: &BigFloat) -> bool {
        let ring = Floats { precision: x.precision() };
        let Ok(mut jet) = Jet::new(&ring, &self.tape, std::slice::from_ref(x)) else { return false };
        ring.rational(&1.into()).is_some_and(|one| jet.extend(&[one]).is_ok())
    }

    /// The force at a position, in the precision of the position.
    pub(super) fn precisely_at(&self, x: &BigFloat) -> Option<BigFloat> {
        self.value(&Floats { precision: x.precision() }, x.clone())
    }

    /// The value at a fraction: evaluated exactly, or computed in digits, recognised and proved; otherwise in digits.
    pub(super) fn constant_at(&self, x: &Rational) -> Option<Constant> {
        let digits = self.precisely_at(&BigFloat::from_rational(x, PRECISION))?;
        let there = self.formula.substitute(self.x, &Expression::Number(x.clone())).simplified();
        if let Expression::Number(value) = there {
            return Some(Constant::Exact(value));
        }
        let candidate = simplest_about(&digits, RECOGNISED_BITS);
        let proved = difference(there, Expression::Number(candidate.clone())).vanishes();
        Some(if proved { Constant::Exact(candidate) } else { Constant::Approximate(Approximation(digits)) })
    }
}

/// The fraction of smallest denominator that agrees with a number to `bits` bits; zero for a number below 2⁻³⁸⁴, which is a rounding error of one with
/// [`PRECISION`] bits.
pub(super) fn simplest_about(number: &BigFloat, bits: usize) -> Rational {
    let value = number.to_rational();
    let least = Rational::from(1).divided_by_power_of_two(3 * PRECISION / 4);
    let width = value.magnitude().divided_by_power_of_two(bits).max(least);
    Rational::simplest_between(&Rationals.subtract(&value, &width), &Rationals.add(&value, &width))
}
