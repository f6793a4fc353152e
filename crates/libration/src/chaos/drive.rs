//! The period of what drives a system.

use std::f64::consts::TAU;

use super::structure::TIME;
use crate::algebra::{Rational, Rationals, Ring};
use crate::expression::{Equation, Expression, Function, Symbol};

/// The drive with the longest common period is this many times the first one's at most.
const LONGEST: i64 = 1000;

/// The period in which the time comes back in the equations, when it stands only in sines and cosines, to the first
/// power with constant factors, which are in simple proportions to each other. `None` without time, and otherwise.
///
/// # Examples
/// ```
/// use libration::chaos::drive_period;
/// use std::f64::consts::TAU;
/// assert_eq!(drive_period(&"x'' = -sin(x) + 1.5*cos(2t/3)".parse()?), Some(1.5 * TAU));
/// assert_eq!(drive_period(&"x'' = -(1 + cos(3t))*x + sin(2t - x)".parse()?), Some(TAU));
/// assert_eq!(drive_period(&"x'' = -x + t".parse()?), None);
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[must_use]
pub fn drive_period(equation: &Equation) -> Option<f64> {
    let time = Symbol::plain(TIME);
    let mut frequencies = vec![];
    let mut formulas = equation.derivatives().iter();
    if !formulas.all(|formula| collect_frequencies(formula, &time, &mut frequencies)) {
        return None;
    }
    let first = frequencies.first()?;
    let ratios: Option<Vec<Rational>> = frequencies.iter().map(|one| ratio(one, first)).collect();
    let times = common_period(&ratios?)?;
    let frequency = first.to_f64()?.abs();
    Some(f64::from(times) * TAU / frequency).filter(|period| period.is_finite())
}

/// The factors of the time in sines and cosines; whether it stands nowhere else.
fn collect_frequencies(formula: &Expression, time: &Symbol, found: &mut Vec<Expression>) -> bool {
    if !formula.contains(time) {
        return true;
    }
    if let Expression::Call(Function::Sin | Function::Cos, argument) = formula {
        let slope = argument.derivative(time);
        if slope.symbols().is_empty() {
            found.push(slope);
            return true;
        }
    }
    let mut inner = formula.parts().peekable();
    inner.peek().is_some() && inner.all(|part| collect_frequencies(part, time, found))
}

fn ratio(a: &Expression, b: &Expression) -> Option<Rational> {
    if a == b {
        return Some(Rational::from(1));
    }
    a.to_rational()?.checked_div(&b.to_rational()?)
}

/// How many periods of the first drive are whole numbers of periods of all.
fn common_period(ratios: &[Rational]) -> Option<i32> {
    let whole = |times: i64| {
        let times = Rational::from(times);
        ratios.iter().all(|ratio| Rationals.multiply(ratio, &times).is_integer())
    };
    (1..=LONGEST).find(|&times| whole(times)).and_then(|times| i32::try_from(times).ok())
}
