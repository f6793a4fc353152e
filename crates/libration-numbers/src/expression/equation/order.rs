//! Choice of the derivative for which each equation is solved.
//!
//! # Method
//! An equation without a second derivative is solved for the first derivative of the variable that has no second derivative in any equation. A
//! state holds all coordinates, then the velocities of the second-order variables; only `StateLayout` knows which component is which. The
//! tolerance of a first-order variable is relative to the distance that it moves, like that of every coordinate: its zero may be arbitrary, as
//! for a phase or a temperature, and a decaying amount moves by its own size. Every function that is defined for accelerations only
//! (oscillators, normal modes, releases from rest, energies) begins with `Equation::refuse_first_order`.

use std::collections::BTreeSet;

use super::{EquationError, Sides, Symbol, TIME};

/// Order of an equation of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// An equation for the rate of change of its variable.
    First,
    /// An equation for the acceleration.
    Second,
}

impl Order {
    /// The order of an equation that is solved for this derivative.
    pub(super) fn of(derivative: &Symbol) -> Self {
        if derivative.primes == 1 { Self::First } else { Self::Second }
    }

    /// The derivative for which an equation of this order is solved.
    pub(super) fn derivative_of(self, variable: &str) -> Symbol {
        let primes = match self {
            Self::First => 1,
            Self::Second => 2,
        };
        Symbol::plain(variable).with_primes(primes)
    }
}

/// The derivative for which each equation is to be solved: its second derivative if it has one, otherwise the first derivative of a variable
/// that has no second derivative in any equation.
pub(super) fn own_derivatives(written: &[Sides]) -> Result<Vec<Symbol>, EquationError> {
    let symbols: Vec<BTreeSet<Symbol>> = written.iter().map(symbols).collect();
    let accelerations = symbols.iter().map(own_acceleration).collect::<Result<Vec<_>, _>>()?;
    let accelerated: BTreeSet<&str> =
        accelerations.iter().flatten().map(|symbol| symbol.name.as_str()).collect();
    let derivatives =
        written.iter().zip(&symbols).zip(&accelerations).map(|((sides, symbols), acceleration)| {
            let derivative = match acceleration {
                Some(acceleration) => acceleration.clone(),
                None => own_rate(sides, symbols, &accelerated)?,
            };
            if derivative.name == TIME { Err(EquationError::TimeAsVariable) } else { Ok(derivative) }
        });
    derivatives.collect()
}

fn symbols((left, right): &Sides) -> BTreeSet<Symbol> {
    let mut symbols = left.symbols();
    symbols.extend(right.symbols());
    symbols
}

/// The only second derivative in an equation, if it has any.
fn own_acceleration(symbols: &BTreeSet<Symbol>) -> Result<Option<Symbol>, EquationError> {
    if let Some(symbol) = symbols.iter().find(|symbol| symbol.primes > 2) {
        return Err(EquationError::ThirdOrder(symbol.clone()));
    }
    only(symbols.iter().filter(|symbol| symbol.primes == 2))
}

/// The only rate of change in an equation without second derivatives.
fn own_rate(
    (left, right): &Sides,
    symbols: &BTreeSet<Symbol>,
    accelerated: &BTreeSet<&str>,
) -> Result<Symbol, EquationError> {
    let mut rates = symbols.iter().filter(|symbol| symbol.primes == 1);
    let candidates = rates.clone().filter(|rate| !accelerated.contains(rate.name.as_str()));
    only(candidates)?.ok_or_else(|| match rates.next() {
        Some(rate) => EquationError::rate_of_accelerated(left, right, rate.clone()),
        None => EquationError::without_derivative(left, right),
    })
}

fn only<'a>(mut symbols: impl Iterator<Item = &'a Symbol>) -> Result<Option<Symbol>, EquationError> {
    match (symbols.next(), symbols.next()) {
        (Some(first), Some(second)) => {
            Err(EquationError::Coupled { first: first.clone(), second: second.clone() })
        }
        (first, _) => Ok(first.cloned()),
    }
}
