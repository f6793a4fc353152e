//! The linear equations of small motions: x″ = −A·x + G·x′.

use super::equilibrium::{Equilibrium, substituted};
use super::error::NoModes;
use crate::algebra::{Doubles, Rational};
use crate::expression::{Equation, Expression, Jet, Symbol, Tape};

/// A and G by rows.
#[derive(Clone, Debug)]
pub(super) struct Linearisation<N> {
    pub(super) stiffness: Vec<Vec<N>>,
    pub(super) velocity: Vec<Vec<N>>,
}

/// In digits, and in fractions where all entries are.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    pub(super) numbers: Linearisation<f64>,
    pub(super) exact: Option<Linearisation<Rational>>,
}

/// The symbols of the coordinates, then of the velocities.
pub(super) fn symbols(equation: &Equation) -> Vec<Symbol> {
    let plain = equation.variables().iter().map(|name| Symbol::plain(name));
    plain.clone().chain(plain.map(|symbol| symbol.with_primes(1))).collect()
}

pub(super) fn linearisation(equation: &Equation, rest: &Equilibrium) -> Result<Linear, NoModes> {
    let symbols = symbols(equation);
    let slopes: Vec<Vec<Expression>> = equation
        .accelerations()
        .iter()
        .map(|formula| symbols.iter().map(|symbol| formula.derivative(symbol)).collect())
        .collect();
    let numbers = in_numbers(&slopes, &symbols, &rest.at)?;
    let exact = rest.exact.as_ref().and_then(|place| in_fractions(&slopes, &symbols, place));
    Ok(Linear {
        numbers: split(&numbers, |x| -x),
        exact: exact.map(|it| split(&it, |x: &Rational| -x.clone())),
    })
}

/// The derivatives by coordinates with the other sign, and those by velocities.
fn split<N: Clone>(slopes: &[Vec<N>], negative: impl Fn(&N) -> N) -> Linearisation<N> {
    let n = slopes.len();
    let stiffness = slopes.iter().map(|row| row[..n].iter().map(&negative).collect()).collect();
    Linearisation { stiffness, velocity: slopes.iter().map(|row| row[n..].to_vec()).collect() }
}

fn in_numbers(slopes: &[Vec<Expression>], symbols: &[Symbol], at: &[f64]) -> Result<Vec<Vec<f64>>, NoModes> {
    let all: Vec<&Expression> = slopes.iter().flatten().collect();
    let tape = Tape::new(&all, symbols)?;
    let state: Vec<f64> = at.iter().copied().chain(at.iter().map(|_| 0.0)).collect();
    let refusal = || NoModes::NotSmooth { at: at.to_vec() };
    let jet = Jet::new(&Doubles, &tape, &state).map_err(|_| refusal())?;
    let values: Vec<f64> = (0..all.len()).map(|i| jet.result(i)[0]).collect();
    if values.iter().all(|x| x.is_finite()) {
        Ok(values.chunks(symbols.len()).map(<[f64]>::to_vec).collect())
    } else {
        Err(refusal())
    }
}

fn in_fractions(
    slopes: &[Vec<Expression>],
    symbols: &[Symbol],
    place: &[Rational],
) -> Option<Vec<Vec<Rational>>> {
    let zeros = place.iter().map(|_| Rational::from(0));
    let values: Vec<Rational> = place.iter().cloned().chain(zeros).collect();
    let value = |formula: &Expression| substituted(formula, symbols, &values).to_rational();
    slopes.iter().map(|row| row.iter().map(value).collect()).collect()
}
