//! Equations of free oscillations: without the drive and without velocities in the force.

use libration_numbers::expression::{Equation, Expression, Function, Order, Symbol};

/// The equation without velocities in the force, and with zero for each sine and
/// cosine of the time; `None` unless it is of second order with one coordinate.
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
