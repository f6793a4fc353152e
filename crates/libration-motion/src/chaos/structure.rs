//! Properties of motions that follow from the form of their equations.

use crate::taylor::StateLayout;
use libration_numbers::expression::{Equation, Expression, Function, Symbol};

/// The name of the time in equations.
pub(super) const TIME: &str = "t";

/// Flags, for each coordinate, whether it is an angle: it occurs in the equations only
/// inside sines and cosines, multiplied by integers, so that a turn changes nothing.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::angles;
/// assert_eq!(angles(&"theta'' = -sin(theta) + x; x'' = -x + cos(2 theta)".parse()?), [true, false]);
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[must_use]
pub fn angles(equation: &Equation) -> Vec<bool> {
    let is_angle = |name: &String| {
        let symbol = Symbol::plain(name);
        let mut formulas = equation.derivatives().iter();
        occurs(equation, &symbol) && formulas.all(|formula| turns_leave(formula, &symbol))
    };
    equation.variables().iter().map(is_angle).collect()
}

/// `true` for each coordinate on which nothing in the equations depends.
pub(super) fn cyclic(equation: &Equation) -> Vec<bool> {
    equation.variables().iter().map(|name| !occurs(equation, &Symbol::plain(name))).collect()
}

fn occurs(equation: &Equation, symbol: &Symbol) -> bool {
    equation.derivatives().iter().any(|formula| formula.contains(symbol))
}

/// Returns `true` if a formula does not change when the coordinate increases by a full turn.
fn turns_leave(formula: &Expression, coordinate: &Symbol) -> bool {
    if !formula.contains(coordinate) {
        return true;
    }
    let both = |a: &Expression, b: &Expression| turns_leave(a, coordinate) && turns_leave(b, coordinate);
    match formula {
        Expression::Number(_) | Expression::Pi | Expression::Symbol(_) => false,
        Expression::Negate(a) => turns_leave(a, coordinate),
        Expression::Add(a, b)
        | Expression::Subtract(a, b)
        | Expression::Multiply(a, b)
        | Expression::Divide(a, b)
        | Expression::Power(a, b) => both(a, b),
        Expression::Call(Function::Sin | Function::Cos | Function::Tan, a) => {
            let slope = a.derivative(coordinate).to_rational();
            slope.is_some_and(|slope| slope.is_integer()) || turns_leave(a, coordinate)
        }
        Expression::Call(_, a) => turns_leave(a, coordinate),
    }
}

/// Returns `true` if the equations contain sign(…), at whose jumps the linearised equations fail.
#[doc(hidden)]
pub fn has_jumps(equation: &Equation) -> bool {
    fn jumps(formula: &Expression) -> bool {
        matches!(formula, Expression::Call(Function::Sign, _)) || formula.parts().any(jumps)
    }
    equation.derivatives().iter().any(jumps)
}

/// The reason why a system cannot have chaotic motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theorem {
    /// One coordinate without the time, or several independent ones, or two whose equations are of first
    /// order: bounded motions in a plane tend to equilibria and periodic motions (Poincaré and Bendixson).
    Plane,
    /// Accelerations linear in coordinates and velocities: deviations grow equally on all motions.
    Linear,
}

/// The theorem that excludes chaos, if one applies.
#[doc(hidden)]
pub fn theorem(equation: &Equation) -> Option<Theorem> {
    if planes(equation) {
        return Some(Theorem::Plane);
    }
    let state = state_symbols(equation);
    let linear = |formula: &Expression| formula.polynomial_degree(&state).is_some_and(|degree| degree <= 1);
    equation.derivatives().iter().all(linear).then_some(Theorem::Linear)
}

/// Returns `true` if a state has at most two components, or each equation depends
/// on its own coordinate and velocity alone; in both cases without the time.
fn planes(equation: &Equation) -> bool {
    let time = Symbol::plain(TIME);
    if StateLayout::new(equation).numbers() <= 2 && !occurs(equation, &time) {
        return true;
    }
    let own = |(name, formula): (&String, &Expression)| {
        let mut symbols = formula.symbols().into_iter();
        symbols.all(|symbol| symbol.name == *name)
    };
    equation.variables().iter().zip(equation.derivatives()).all(own)
}

fn state_symbols(equation: &Equation) -> Vec<Symbol> {
    let coordinates = equation.variables().iter().map(|name| Symbol::plain(name));
    coordinates.flat_map(|symbol| [symbol.with_primes(1), symbol]).collect()
}
