//! Forces proportional to one power of the displacement: −k·x³, −k·x|x|, −k·sign(x)·|x|^p.

use super::centre::centre_of;
use super::force::Curve;
use super::model::force;
use super::sides::Sides;
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Equation, Expression, Function, Symbol};

/// The force −k·sign(x)·|x|ᵖ about a centre, with p ≥ 0 other than 1. It has no frequency of small oscillations, and no expansion.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::oscillator::PurePower;
/// let law = PurePower::of(&"x'' + k*x*abs(x) = 0".parse()?, None).ok_or("no power")?;
/// assert_eq!((law.exponent().to_string(), law.strength().to_string()), ("2".into(), "k".into()));
/// assert_eq!(PurePower::of(&"x'' + x^3 + x = 0".parse()?, None), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PurePower {
    variable: String,
    centre: Rational,
    strength: Expression,
    exponent: Rational,
}

impl PurePower {
    /// The pure-power force of an equation of motion, which may have symbolic parameters, taken as positive. The displacement counts from a
    /// given position, or else from the stable equilibrium nearest to zero. `None` for other forces.
    #[must_use]
    pub fn of(equation: &Equation, about: Option<&Expression>) -> Option<Self> {
        let force = force(equation).ok().filter(|force| !force.uses_velocity())?;
        let centre = match (equation.parameters().is_empty(), about) {
            (true, about) => centre_of(equation, about)?.exact()?.clone(),
            (false, None) => Rational::from(0),
            (false, Some(centre)) => centre.to_rational()?,
        };
        let sides = Sides::about(&force, &centre)?;
        let (above, below) = (Monomial::of(&sides.above, &force.x)?, Monomial::of(&sides.below, &force.x)?);
        if above.exponent != below.exponent || !is_same(&above.factor, &below.factor) {
            return None;
        }
        let strength = Expression::Negate(Box::new(above.factor)).simplified();
        let power = Self { variable: force.x.name.clone(), centre, strength, exponent: above.exponent };
        let linear = power.exponent == Rational::from(1);
        (power.strength_if_letters_are_one()? > 0.0 && !power.exponent.is_negative() && !linear)
            .then_some(power)
    }

    /// The name of the displacement.
    #[must_use]
    pub fn variable(&self) -> &str {
        &self.variable
    }

    /// The position towards which the force points.
    #[must_use]
    pub fn centre(&self) -> &Rational {
        &self.centre
    }

    /// k, a formula of the symbolic parameters.
    #[must_use]
    pub fn strength(&self) -> &Expression {
        &self.strength
    }

    /// The value of k; `None` if it contains symbols.
    #[must_use]
    pub fn strength_value(&self) -> Option<f64> {
        if self.strength.symbols().is_empty() { self.strength_if_letters_are_one() } else { None }
    }

    /// p.
    #[must_use]
    pub fn exponent(&self) -> &Rational {
        &self.exponent
    }

    fn strength_if_letters_are_one(&self) -> Option<f64> {
        let letters = self.strength.symbols();
        let number = letters
            .iter()
            .fold(self.strength.clone(), |partial, letter| partial.substitute(letter, &1.into()));
        Some(Curve::new(&number, &Symbol::plain(&self.variable))?.at(0.0)).filter(|value| value.is_finite())
    }
}

/// c·xⁿ for x > 0.
struct Monomial {
    factor: Expression,
    exponent: Rational,
}

impl Monomial {
    fn of(formula: &Expression, x: &Symbol) -> Option<Self> {
        if !formula.contains(x) {
            return Some(Self { factor: formula.clone(), exponent: Rational::from(0) });
        }
        if let Some(polynomial) = Self::of_polynomial(formula, x) {
            return Some(polynomial);
        }
        match formula {
            Expression::Symbol(_) => Some(Self { factor: 1.into(), exponent: Rational::from(1) }),
            Expression::Negate(a) => {
                let Self { factor, exponent } = Self::of(a, x)?;
                Some(Self { factor: Expression::Negate(Box::new(factor)), exponent })
            }
            Expression::Add(a, b) => Self::of(a, x)?.joined(Self::of(b, x)?, Expression::Add),
            Expression::Subtract(a, b) => Self::of(a, x)?.joined(Self::of(b, x)?, Expression::Subtract),
            Expression::Multiply(a, b) => {
                let (a, b) = (Self::of(a, x)?, Self::of(b, x)?);
                let factor = Expression::Multiply(Box::new(a.factor), Box::new(b.factor));
                Some(Self { factor, exponent: Rationals.add(&a.exponent, &b.exponent) })
            }
            Expression::Divide(a, b) => {
                let (a, b) = (Self::of(a, x)?, Self::of(b, x)?);
                let factor = Expression::Divide(Box::new(a.factor), Box::new(b.factor));
                Some(Self { factor, exponent: Rationals.subtract(&a.exponent, &b.exponent) })
            }
            Expression::Power(a, b) => Self::of(a, x)?.power(&b.to_rational()?),
            Expression::Call(Function::Sqrt, a) => Self::of(a, x)?.power(&Rational::new(1, 2)?),
            _ => None,
        }
    }

    /// The monomial to which a polynomial with fractions reduces if all its other terms cancel.
    fn of_polynomial(formula: &Expression, x: &Symbol) -> Option<Self> {
        let coefficients = formula.polynomial_coefficients(x)?;
        let mut present =
            coefficients.into_iter().enumerate().filter(|(_, coefficient)| !coefficient.is_zero());
        let ((power, factor), None) = (present.next()?, present.next()) else { return None };
        Some(Self { factor: Expression::Number(factor), exponent: i64::try_from(power).ok()?.into() })
    }

    /// The sum or the difference of this monomial and one of the same power.
    fn joined(
        self,
        other: Self,
        join: impl Fn(Box<Expression>, Box<Expression>) -> Expression,
    ) -> Option<Self> {
        let Self { factor, exponent } = self;
        let is_same = exponent == other.exponent;
        is_same.then(|| Self { factor: join(Box::new(factor), Box::new(other.factor)), exponent })
    }

    fn power(self, by: &Rational) -> Option<Self> {
        let factor = Expression::Power(Box::new(self.factor), Box::new(Expression::Number(by.clone())));
        Some(Self { factor: factor.simplified(), exponent: Rationals.multiply(&self.exponent, by) })
    }
}

fn is_same(a: &Expression, b: &Expression) -> bool {
    Expression::Subtract(Box::new(a.clone()), Box::new(b.clone())).vanishes()
}
