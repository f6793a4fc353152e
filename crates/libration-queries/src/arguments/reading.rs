//! Notes on how equations were read that are written more freely than they are written back.

use crate::call;
use libration::expression::Equation;

/// Says how a text is understood, unless it is plain.
pub(super) fn say(text: &str) {
    if let Some(reading) = Equation::read_as(text) {
        call::current().note(&format!("the equation is read as {reading}"));
    }
}
