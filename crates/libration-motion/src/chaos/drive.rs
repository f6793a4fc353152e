//! The period of a system's drive.

use std::f64::consts::TAU;

use super::repetitions::repetitions;
use super::structure::TIME;
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Equation, Expression, Function, Symbol};

/// Largest number of periods of the first drive in the common period.
const LONGEST: i64 = 1000;

/// The least period of the equations in the time, if the time occurs only in sines and cosines, to first power
/// with constant factors in simple proportions. `None` without a drive, and in all other cases.
///
/// It may be a part of the common period of the sines and cosines, as for cos(ωt)² or |cos(ωt)|.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::drive_period;
/// use std::f64::consts::TAU;
/// assert_eq!(drive_period(&"x'' = -sin(x) + 1.5*cos(2t/3)".parse()?), Some(1.5 * TAU));
/// assert_eq!(drive_period(&"x'' = -(1 + cos(3t))*x + sin(2t - x)".parse()?), Some(TAU));
/// assert_eq!(drive_period(&"x'' = -x + cos(t)^2".parse()?), Some(TAU / 2.0));
/// assert_eq!(drive_period(&"x'' = -x + t".parse()?), None);
/// # Ok::<(), libration::expression::EquationError>(())
/// ```
#[must_use]
pub fn drive_period(equation: &Equation) -> Option<f64> {
    let (frequency, times) = drive_frequency(equation)?;
    let frequency = frequency.to_f64()?.abs();
    Some(f64::from(times) * TAU / frequency).filter(|period| period.is_finite())
}

/// An angular frequency, which may contain symbolic parameters, and the number of its
/// periods in the least period of the equations; `None` as for [`drive_period`].
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::drive_frequency;
/// let (frequency, times) = drive_frequency(&"x'' = -x + cos(2*w*t) + cos(3*w*t)".parse()?).ok_or("no drive")?;
/// assert_eq!((frequency.to_string().as_str(), times), ("2*w", 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn drive_frequency(equation: &Equation) -> Option<(Expression, i32)> {
    let WrittenDrive { frequency, times, repetitions } = WrittenDrive::of(equation)?;
    let shared = (1..=times).rev().find(|divisor| times % divisor == 0 && repetitions % divisor == 0)?;
    let factor = repetitions / shared;
    let frequency = match factor {
        1 => frequency,
        _ => {
            let factor = Expression::from(i64::from(factor));
            Expression::Multiply(Box::new(factor), Box::new(frequency)).simplified()
        }
    };
    Some((frequency, times / shared))
}

/// The sines and cosines of the time as they stand in equations.
#[derive(Clone, Debug)]
pub struct WrittenDrive {
    /// The angular frequency of the first of them, which may contain symbolic parameters.
    frequency: Expression,
    /// The number of its periods in their common period.
    times: i32,
    /// The number of least periods of the equations in this common period.
    pub repetitions: i32,
}

impl WrittenDrive {
    /// `None` as for [`drive_period`].
    #[must_use]
    pub fn of(equation: &Equation) -> Option<Self> {
        let (frequency, times) = common_frequency(equation)?;
        let repetitions = repetitions(equation, &frequency, times);
        Some(Self { frequency, times, repetitions })
    }
}

/// The angular frequency of the first sine or cosine of the time, and the number of its periods in the common period of all of them.
fn common_frequency(equation: &Equation) -> Option<(Expression, i32)> {
    let time = Symbol::plain(TIME);
    let parameters = equation.parameters();
    let is_constant = |slope: &Expression| {
        slope.symbols().iter().all(|symbol| symbol.primes == 0 && parameters.contains(&symbol.name))
    };
    let mut frequencies = vec![];
    let mut formulas = equation.derivatives().iter();
    if !formulas.all(|formula| collect_frequencies(formula, &time, &is_constant, &mut frequencies)) {
        return None;
    }
    let first = frequencies.first()?;
    let ratios: Option<Vec<Rational>> = frequencies.iter().map(|one| ratio(one, first)).collect();
    let times = common_period(&ratios?)?;
    Some((first.clone(), times))
}

/// Collects the factors of the time in sines and cosines; returns `true` if the time occurs nowhere else.
fn collect_frequencies(
    formula: &Expression,
    time: &Symbol,
    is_constant: &impl Fn(&Expression) -> bool,
    frequencies: &mut Vec<Expression>,
) -> bool {
    if !formula.contains(time) {
        return true;
    }
    if let Expression::Call(Function::Sin | Function::Cos, argument) = formula {
        let slope = argument.derivative(time);
        if is_constant(&slope) {
            frequencies.push(slope);
            return true;
        }
    }
    let mut inner = formula.parts().peekable();
    inner.peek().is_some() && inner.all(|part| collect_frequencies(part, time, is_constant, frequencies))
}

/// The quotient of two frequencies; with symbols it must be the same for all their values.
fn ratio(a: &Expression, b: &Expression) -> Option<Rational> {
    if a == b {
        return Some(Rational::from(1));
    }
    let at = |values: [i64; 2]| {
        let letters: Vec<Symbol> = a.symbols().into_iter().chain(b.symbols()).collect();
        let put_in = |formula: &Expression| {
            let values = values.iter().cycle().map(|&value| Expression::from(value));
            let filled = letters
                .iter()
                .zip(values)
                .fold(formula.clone(), |partial, (letter, value)| partial.substitute(letter, &value));
            filled.simplified().to_rational()
        };
        put_in(a)?.checked_div(&put_in(b)?)
    };
    at([2, 3]).filter(|ratio| at([5, 7]).as_ref() == Some(ratio))
}

/// Smallest number of periods of the first drive that is a whole number of periods of every drive; `None` above [`LONGEST`].
fn common_period(ratios: &[Rational]) -> Option<i32> {
    let whole = |times: i64| {
        let times = Rational::from(times);
        ratios.iter().all(|ratio| Rationals.multiply(ratio, &times).is_integer())
    };
    (1..=LONGEST).find(|&times| whole(times)).and_then(|times| i32::try_from(times).ok())
}
