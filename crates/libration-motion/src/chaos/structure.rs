//! Properties of motions that follow from the form of their equations.

use crate::taylor::StateLayout;
use crate::taylor::program::open_signs::OpenSigns;
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Equation, Expression, Function, Symbol};
use libration_numbers::internals::algebra::InOrder;

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
    (0..equation.variables().len()).map(|coordinate| turn_together(equation, &[coordinate])).collect()
}

/// Groups of coordinates that turn together without a change of the equations: every angle is one, and pendulums that a spring of their
/// difference couples are another.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::turning_groups;
/// let coupled = "x'' = -sin(x) + y - x; y'' = -sin(y) + x - y; theta'' = -sin(theta)".parse()?;
/// assert_eq!(turning_groups(&coupled), [vec![2], vec![0, 1]]);
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[must_use]
pub fn turning_groups(equation: &Equation) -> Vec<Vec<usize>> {
    /// Largest number of coordinates of which all groups are tried; of more, all together are.
    const MOST_TRIED: usize = 8;
    let (angles, others): (Vec<usize>, Vec<usize>) =
        (0..equation.variables().len()).partition(|coordinate| turn_together(equation, &[*coordinate]));
    let mut groups: Vec<Vec<usize>> = angles.into_iter().map(|angle| vec![angle]).collect();
    let mut candidates: Vec<Vec<usize>> =
        if others.len() > MOST_TRIED { vec![others] } else { subsets(&others) };
    candidates.retain(|candidate| candidate.len() > 1);
    candidates.put_in_order_by(Vec::len);
    for candidate in candidates {
        let is_free =
            candidate.iter().all(|coordinate| groups.iter().all(|group| !group.contains(coordinate)));
        if is_free && turn_together(equation, &candidate) {
            groups.push(candidate);
        }
    }
    groups
}

fn subsets(of: &[usize]) -> Vec<Vec<usize>> {
    of.iter().fold(vec![vec![]], |subsets, new| {
        let with_new =
            subsets.iter().map(|subset: &Vec<usize>| subset.iter().chain([new]).copied().collect());
        subsets.iter().cloned().chain(with_new).collect()
    })
}

/// Returns `true` if the coordinates occur in the equations, and a turn of all of them changes nothing, but a part of it does.
fn turn_together(equation: &Equation, coordinates: &[usize]) -> bool {
    let symbols: Vec<Symbol> =
        coordinates.iter().map(|coordinate| Symbol::plain(&equation.variables()[*coordinate])).collect();
    let formulas = equation.derivatives();
    symbols.iter().all(|symbol| occurs(equation, symbol))
        && formulas.iter().all(|formula| turns_leave(formula, &symbols))
        && !formulas.iter().all(|formula| slope(formula, &symbols).vanishes())
}

/// `true` for each coordinate on which nothing in the equations depends.
pub(super) fn cyclic(equation: &Equation) -> Vec<bool> {
    equation.variables().iter().map(|name| !occurs(equation, &Symbol::plain(name))).collect()
}

fn occurs(equation: &Equation, symbol: &Symbol) -> bool {
    equation.derivatives().iter().any(|formula| formula.contains(symbol))
}

/// Returns `true` if a formula does not change when these coordinates increase by a full turn: with the values of functions that a turn
/// leaves taken as constants, its slope in the direction of the turn vanishes. Sines and cosines of half angles change their signs.
fn turns_leave(formula: &Expression, turning: &[Symbol]) -> bool {
    let change = || Expression::Subtract(Box::new(formula.clone()), Box::new(after_turn(formula, turning)));
    functions_stay(formula, turning)
        && slope(&with_constants(formula, turning), turning).vanishes()
        && change().vanishes()
}

/// Returns `true` if no value of a function in a formula changes, apart from signs of sines and cosines.
fn functions_stay(formula: &Expression, turning: &[Symbol]) -> bool {
    match formula {
        Expression::Call(function, a) => {
            let is_periodic = matches!(function, Function::Sin | Function::Cos | Function::Tan);
            let half_turns = half_turns(a, turning).filter(|_| is_periodic);
            half_turns.is_some_and(|turns| turns.is_integer()) || turns_leave(a, turning)
        }
        _ => formula.parts().all(|part| functions_stay(part, turning)),
    }
}

/// The number of half turns of an argument during a full turn, if it is a number.
fn half_turns(argument: &Expression, turning: &[Symbol]) -> Option<Rational> {
    let turns = slope(argument, turning).to_rational()?;
    Some(Rationals.add(&turns, &turns))
}

/// The formula after a full turn, which changes the signs of sines and cosines of half angles.
fn after_turn(formula: &Expression, turning: &[Symbol]) -> Expression {
    let is_odd = |turns: Rational| Rationals.over_integer(&turns, 2).is_some_and(|half| !half.is_integer());
    match formula {
        Expression::Call(Function::Sin | Function::Cos, a) if half_turns(a, turning).is_some_and(is_odd) => {
            Expression::Negate(Box::new(formula.clone()))
        }
        _ => formula.with_parts(|part| after_turn(part, turning)),
    }
}

/// The formula with other symbols in the place of these inside functions.
fn with_constants(formula: &Expression, turning: &[Symbol]) -> Expression {
    match formula {
        Expression::Call(..) => turning.iter().fold(formula.clone(), |formula, symbol| {
            formula.substitute(symbol, &Expression::Symbol(symbol.with_primes(u8::MAX)))
        }),
        _ => formula.with_parts(|part| with_constants(part, turning)),
    }
}

/// The sum of the derivatives by these coordinates.
fn slope(formula: &Expression, turning: &[Symbol]) -> Expression {
    let slopes = turning.iter().map(|symbol| formula.derivative(symbol));
    let sum = |a: Expression, b| Expression::Add(Box::new(a), Box::new(b));
    slopes.reduce(sum).unwrap_or_else(|| Expression::Number(0.into()))
}

/// Returns `true` if the equations contain sign(…), or x/|x|, at whose jumps the linearised equations fail.
#[doc(hidden)]
pub fn has_jumps(equation: &Equation) -> bool {
    fn jumps(formula: &Expression) -> bool {
        matches!(formula, Expression::Call(Function::Sign, _)) || formula.parts().any(jumps)
    }
    equation.derivatives().iter().any(jumps) || OpenSigns::new(equation).is_some()
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
    let is_alone = |(name, formula): (&String, &Expression)| {
        let mut symbols = formula.symbols().into_iter();
        symbols.all(|symbol| symbol.name == *name)
    };
    equation.variables().iter().zip(equation.derivatives()).all(is_alone)
}

fn state_symbols(equation: &Equation) -> Vec<Symbol> {
    let coordinates = equation.variables().iter().map(|name| Symbol::plain(name));
    coordinates.flat_map(|symbol| [symbol.with_primes(1), symbol]).collect()
}
