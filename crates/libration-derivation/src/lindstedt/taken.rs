//! The symbols of the derivation, which an equation may have for something else.

use super::reduced::omega0;
use crate::check::DerivationError;
use crate::formula::{Formula, Name, Subscript};
use crate::renaming::Renaming;
use libration::expression::{Expression, Symbol};
use libration::oscillator::{NumbersOrLetters, SymbolicOscillator};

/// Symbols of the derivation.
const ALONE: [&str; 9] = ["t", "τ", "T", "ε", "Δ", "Ω", "F", "π", "u"];
/// Symbols of the derivation with a number as subscript: coefficients, factors of the force, and parts of the conditions.
const NUMBERED: [&str; 14] = ["a", "b", "d", "f", "g", "t", "A", "B", "C", "P", "Q", "R", "T", "ε"];

/// The oscillator with free symbols, and what was replaced.
pub(super) fn renamed(oscillator: NumbersOrLetters) -> Result<(NumbersOrLetters, Renaming), DerivationError> {
    let NumbersOrLetters::Letters(symbolic) = &oscillator else {
        return Ok((oscillator, Renaming::default()));
    };
    let letters = symbolic.letters().iter();
    let renaming = Renaming::new(letters, symbolic.variable(), |name| is_taken(name, symbolic))?;
    if renaming.is_empty() {
        return Ok((oscillator, renaming));
    }
    let what = "an oscillator and the same with other symbols";
    let position = renaming.replaced(&symbolic.equilibrium().to_string());
    let position: Expression = position.parse().map_err(|_| DerivationError::Disagreement { what })?;
    let symbolic = SymbolicOscillator::about(&renaming.of(symbolic.equation())?, &position);
    let symbolic = symbolic.map_err(|_| DerivationError::Disagreement { what })?;
    Ok((NumbersOrLetters::Letters(symbolic), renaming))
}

fn is_taken(name: &str, oscillator: &SymbolicOscillator) -> bool {
    let written = Name::from(&Symbol::plain(name));
    // The symbol of the derivation with the same meaning.
    let is_frequency = || oscillator.omega0_squared().to_string() == format!("{name}^2");
    match &written.subscript {
        _ if Formula::from(written.clone()) == omega0() => !is_frequency(),
        None => ALONE.contains(&&*written.letter),
        Some(Subscript::Index(_)) => {
            let of_displacement = Name::from(&Symbol::plain(oscillator.variable())).letter;
            NUMBERED.contains(&&*written.letter) || written.letter == of_displacement
        }
        Some(Subscript::Word(_)) => false,
    }
}
