//! Backbone curve: the free oscillations of a driven oscillator, without its drive and without velocities in its force.

use libration_motion::orbit::Orbit;
use libration_numbers::expression::{Equation, Expression, Function, Order, Symbol};
use libration_numbers::progress::Quiet;

/// Frequencies and amplitudes of the free oscillations of one coordinate from rest at some places, without velocities in the force and
/// with zero for each sine and cosine of the time: what resonances of the driven oscillator lean on. Places without an orbit are left out.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::continuation::free_oscillations;
/// let driven = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(0.8*t)".parse()?;
/// let exact = libration::pendulum::Pendulum::from_angular_frequency(1.0)?.released_from("60deg".parse()?)?.period();
/// let [(frequency, _)] = free_oscillations(&driven, &[std::f64::consts::FRAC_PI_3])[..] else { return Err("no orbit".into()) };
/// assert!((frequency - std::f64::consts::TAU / exact).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn free_oscillations(equation: &Equation, places: &[f64]) -> Vec<(f64, f64)> {
    let Some(free) = undriven(equation) else { return vec![] };
    let orbit = |place: &f64| Some((Orbit::released(&free, *place, &Quiet).ok()?.frequency(), *place));
    places.iter().filter_map(orbit).collect()
}

/// Without velocities in the force and with zero for each sine and cosine of the time; `None` but for one coordinate of the second order.
pub(super) fn undriven(equation: &Equation) -> Option<Equation> {
    let ([variable], [Order::Second]) = (equation.variables(), equation.orders()) else { return None };
    let zero = Expression::from(0);
    let velocity = Symbol::plain(variable).with_primes(1);
    let at_rest = without_drive(&equation.derivatives()[0]).substitute(&velocity, &zero).simplified();
    Some(Equation::of_derivatives(vec![variable.clone()], vec![Order::Second], vec![at_rest]))
}

/// The formula with zero for each sine and cosine of the time.
fn without_drive(formula: &Expression) -> Expression {
    let inner = |part: &Expression| Box::new(without_drive(part));
    let time = Symbol::plain("t");
    match formula {
        Expression::Call(Function::Sin | Function::Cos, argument)
            if argument.derivative(&time).simplified() != Expression::from(0) =>
        {
            Expression::from(0)
        }
        Expression::Number(_) | Expression::Pi | Expression::Symbol(_) => formula.clone(),
        Expression::Negate(a) => Expression::Negate(inner(a)),
        Expression::Add(a, b) => Expression::Add(inner(a), inner(b)),
        Expression::Subtract(a, b) => Expression::Subtract(inner(a), inner(b)),
        Expression::Multiply(a, b) => Expression::Multiply(inner(a), inner(b)),
        Expression::Divide(a, b) => Expression::Divide(inner(a), inner(b)),
        Expression::Power(a, b) => Expression::Power(inner(a), inner(b)),
        Expression::Call(function, a) => Expression::Call(*function, inner(a)),
    }
}
