//! Expansions with letters.

use super::answer::ExpandResult;
use super::numbers::with_orders_shown;
use crate::arguments::Chosen;
use crate::query_error::QueryError;
use libration::algebra::LaurentPolynomial;
use libration::oscillator::SymbolicOscillator;
use libration::perturbation::{Gauge, SymbolicExpansionError, expand_symbolically};

pub(super) fn answer(
    chosen: Chosen<SymbolicOscillator>,
    order: usize,
    gauge: &Gauge,
) -> Result<ExpandResult<LaurentPolynomial>, QueryError> {
    let equation = chosen.oscillator.equation().clone();
    let expansion =
        with_orders_shown(order, |progress| expand_symbolically(&chosen.oscillator, order, gauge, progress));
    match expansion {
        Ok(expansion) => Ok(ExpandResult::with_letters(&equation, chosen, expansion, None)),
        Err(SymbolicExpansionError::Interrupted { known: Some(partial) }) => {
            Ok(ExpandResult::with_letters(&equation, chosen, *partial, Some(order)))
        }
        Err(SymbolicExpansionError::Interrupted { known: None }) => {
            Err(QueryError::cancelled("interrupted before any order was found"))
        }
        Err(error) => Err(QueryError::no_result("expansion", error)),
    }
}
