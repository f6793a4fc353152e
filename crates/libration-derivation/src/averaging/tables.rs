//! Sums in the cells of tables.

use super::super::formula::Formula;
use super::super::prose::Prose;

/// A sum term by term; a line may end between terms.
pub(crate) fn in_terms(formula: &Formula) -> Prose {
    let Formula::Sum(terms) = formula else { return Prose::formula(formula.clone()) };
    let mut prose = Prose::text("");
    for (index, term) in terms.iter().enumerate() {
        let (sign, size) = match (index, is_negative(term)) {
            (0, _) => ("", term.clone()),
            (_, true) => (" − ", term.clone().negated()),
            (_, false) => (" + ", term.clone()),
        };
        prose = prose.and(Prose::text(sign)).and(Prose::formula(size));
    }
    prose
}

fn is_negative(term: &Formula) -> bool {
    match term {
        Formula::Negate(_) => true,
        Formula::Number(value) => value.is_negative(),
        Formula::Product(factors) => factors.first().is_some_and(is_negative),
        _ => false,
    }
}
