//! Notes on the reading of equations whose text differs from the plain spelling.

use crate::call;
use libration::expression::Equation;

/// Writes a note on the reading of a text, unless it has the plain spelling.
pub(super) fn say(text: &str) {
    if let Some(reading) = Equation::read_as(text) {
        call::current().note(&format!("the equation is read as {reading}"));
    }
}
