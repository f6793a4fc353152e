//! Expansions with letters.

use super::answer::{Answer, Letters};
use super::numbers::with_orders_shown;
use crate::arguments::Chosen;
use crate::query_error::QueryError;
use libration::algebra::LaurentPolynomial;
use libration::expression::Equation;
use libration::oscillator::SymbolicOscillator;
use libration::perturbation::{Gauge, SymbolicExpansion, SymbolicExpansionError, expand_symbolically};

pub(super) fn answer(
    chosen: Chosen<SymbolicOscillator>,
    order: usize,
    gauge: &Gauge,
) -> Result<Answer<LaurentPolynomial>, QueryError> {
    let equation = chosen.oscillator.equation().clone();
    let expansion =
        with_orders_shown(order, |progress| expand_symbolically(&chosen.oscillator, order, gauge, progress));
    match expansion {
        Ok(expansion) => Ok(in_words(&equation, chosen, expansion, None)),
        Err(SymbolicExpansionError::Interrupted { known: Some(known) }) => {
            Ok(in_words(&equation, chosen, *known, Some(order)))
        }
        Err(SymbolicExpansionError::Interrupted { known: None }) => {
            Err(QueryError::cancelled("interrupted before any order was found"))
        }
        Err(error) => Err(QueryError::no_result("expansion", error)),
    }
}

/// A symbolic expansion with the words for its oscillator.
pub(super) fn in_words<O>(
    equation: &Equation,
    chosen: Chosen<O>,
    expansion: SymbolicExpansion,
    interrupted: Option<usize>,
) -> Answer<LaurentPolynomial> {
    let frequency = expansion.frequency();
    let SymbolicExpansion { letters: names, constants, omega0, omega0_name, series } = expansion;
    let constants = constants.into_iter().map(|(name, constant)| (name, constant.to_string())).collect();
    let omega0 = omega0.map_or_else(|| format!("sqrt({})", series.omega0_squared), |root| root.to_string());
    let letters = Letters { names, constants, omega0, omega0_name, frequency };
    Answer::about(equation, chosen, series, Some(letters), interrupted)
}
