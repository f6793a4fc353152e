//! A force with one power series above the equilibrium and another below, as x + x|x| has about zero.

use super::constant::{Constant, PRECISION};
use super::force::{Curve, Force};
use libration_numbers::algebra::{Floats, Rational, Rationals, Ring};
use libration_numbers::expression::{Expression, Function, Symbol};

/// The force on both sides, each as a formula of the distance from the equilibrium: F(xₑ + y) and −F(xₑ − y).
#[derive(Clone, Debug)]
pub struct Sides {
    #[doc(hidden)]
    pub above: Expression,
    #[doc(hidden)]
    pub below: Expression,
}

/// Maximum number of derivatives that are evaluated for the sign of a function that vanishes at the equilibrium.
const MOST_DERIVATIVES: usize = 12;

impl Sides {
    /// The sides, and their common slope; `None` if the force contains the velocity,
    /// a side has no power series in fractions, or the force jumps or has a kink.
    pub(super) fn new(force: &Force, at: &Constant) -> Option<(Self, Rational)> {
        let sides = at.exact().and_then(|centre| Self::about(force, centre))?;
        let (above, below) =
            (slope_from_rest(&sides.above, &force.x)?, slope_from_rest(&sides.below, &force.x)?);
        (above == below).then_some((sides, above))
    }

    /// The sides of any position; `None` if the force contains the velocity.
    pub(super) fn about(force: &Force, position: &Rational) -> Option<Self> {
        if force.uses_velocity() {
            return None;
        }
        let at_rest = force.at_rest();
        let from = |sign: i64| {
            let distance =
                Expression::Multiply(Box::new(sign.into()), Box::new(Expression::Symbol(force.x.clone())));
            let moved = Expression::Add(Box::new(Expression::Number(position.clone())), Box::new(distance));
            let formula = without_kinks(&at_rest.substitute(&force.x, &moved), &force.x);
            Expression::Multiply(Box::new(sign.into()), Box::new(formula)).simplified()
        };
        Some(Self { above: from(1), below: from(-1) })
    }
}

/// The slope at zero of a formula that is proved to be analytic and to vanish there; otherwise `None`.
fn slope_from_rest(side: &Expression, x: &Symbol) -> Option<Rational> {
    let (zero, digits) = (Rational::from(0), Floats { precision: PRECISION });
    side.taylor_series(&digits, x, &digits.zero(), MOST_DERIVATIVES)?;
    let at_zero = |formula: &Expression| Curve::new(formula, x)?.constant_at(&zero)?.exact().cloned();
    at_zero(side)?.is_zero().then(|| at_zero(&side.derivative(x).simplified()))?
}

/// The formula for small x > 0, with ±u for |u| and ±1 for sign(u) if u vanishes at zero.
fn without_kinks(formula: &Expression, x: &Symbol) -> Expression {
    let seen = formula.with_parts(|part| without_kinks(part, x));
    let Expression::Call(function @ (Function::Abs | Function::Sign), of) = &seen else { return seen };
    let Some(sign) = sign_above_zero(of, x) else { return seen };
    match function {
        Function::Abs => Expression::Multiply(Box::new(sign.into()), of.clone()),
        _ => sign.into(),
    }
}

/// The sign, next to zero, of a function that vanishes at zero: that of its first derivative that does not vanish.
fn sign_above_zero(formula: &Expression, x: &Symbol) -> Option<i64> {
    let series = formula.taylor_series(&Rationals, x, &Rational::from(0), MOST_DERIVATIVES)?;
    let first = series.iter().find(|coefficient| !coefficient.is_zero())?;
    series[0].is_zero().then_some(if first.is_negative() { -1 } else { 1 })
}
