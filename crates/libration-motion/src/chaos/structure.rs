//! What the form of the equations tells about their motions.

use crate::taylor::StateLayout;
use libration_numbers::expression::{Equation, Expression, Function, Symbol};

/// The name of the time in equations.
pub(super) const TIME: &str = "t";

/// For each coordinate, whether it is an angle: it stands in the equations only inside sines and cosines, multiplied by
/// whole numbers, so that a turn changes nothing.
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

/// For each coordinate, whether nothing in the equations depends on it.
pub(super) fn cyclic(equation: &Equation) -> Vec<bool> {
    equation.variables().iter().map(|name| !occurs(equation, &Symbol::plain(name))).collect()
}

fn occurs(equation: &Equation, symbol: &Symbol) -> bool {
    equation.derivatives().iter().any(|formula| formula.contains(symbol))
}

/// Whether a formula is the same after a turn of the coordinate.
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

/// Whether sign(…) stands in the equations, at whose jumps the linearised equations fail.
pub(super) fn has_jumps(equation: &Equation) -> bool {
    fn jumps(formula: &Expression) -> bool {
        matches!(formula, Expression::Call(Function::Sign, _)) || formula.parts().any(jumps)
    }
    equation.derivatives().iter().any(jumps)
}

/// Why no motion of a system can be chaotic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theorem {
    /// One coordinate without the time, or several that know nothing of each other, or two whose equations are of the first order: in a
    /// plane bounded motions tend to equilibria and periodic motions (Poincaré and Bendixson).
    Plane,
    /// Accelerations of the first degree in coordinates and velocities: deviations grow alike on all motions.
    Linear,
}

/// The theorem that forbids chaos, if one is found.
pub(super) fn theorem(equation: &Equation) -> Option<Theorem> {
    if planes(equation) {
        return Some(Theorem::Plane);
    }
    let state = state_symbols(equation);
    let linear = |formula: &Expression| formula.polynomial_degree(&state).is_some_and(|degree| degree <= 1);
    equation.derivatives().iter().all(linear).then_some(Theorem::Linear)
}

/// Whether a state has two numbers at most, or each equation depends on its own coordinate and velocity alone; always without the time.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn equation(text: &str) -> Equation {
        text.parse().unwrap()
    }

    #[test]
    fn an_angle_is_left_alone_by_a_turn() {
        assert_eq!(
            angles(&equation("a'' = -sin(a - b) + cos(2t - a); b'' = sin(a - b)*exp(cos(b))")),
            [true, true]
        );
        assert_eq!(angles(&equation("x'' = -sin(x/2)")), [false]);
        assert_eq!(angles(&equation("x'' = -x*cos(x)")), [false]);
        assert_eq!(angles(&equation("x'' = -x'")), [false]);
    }

    #[test]
    fn jumps_are_found_where_they_remain() {
        let friction = equation("x'' = -x - c*sign(x') - x'*abs(x')");
        assert!(has_jumps(&friction));
        assert!(!has_jumps(&friction.with(&[("c", Expression::from(0))]).unwrap()));
    }

    #[test]
    fn theorems_are_found_where_they_hold() {
        let cases = [
            ("x'' = x - x^3 - x'/3", Some(Theorem::Plane)),
            ("x'' = -sin(x); y'' = -y*y'^2", Some(Theorem::Plane)),
            ("x' = x - x*y; y' = x*y - y", Some(Theorem::Plane)),
            ("x' = x - x*y; y' = x*y - y*cos(t)", None),
            ("x' = -y - z; y' = x + y/5; z' = 1 + z*(x - 6)", None),
            ("x'' = -x*q; q' = -q", None),
            ("x' = -y - z*sin(t); y' = x + y/5; z' = 1 + z", Some(Theorem::Linear)),
            ("x'' = -2x + y*cos(t); y'' = x - y' + exp(t)", Some(Theorem::Linear)),
            ("x'' = -sin(x) + cos(t)", None),
            ("x'' = -sin(x); y'' = x - y", None),
            ("x'' = (1 + x)^2 - x^2 - x/(2 + t)", Some(Theorem::Linear)),
        ];
        for (text, expected) in cases {
            assert_eq!(theorem(&equation(text)), expected, "{text}");
        }
    }
}
