//! How equations were read that are written more freely than they are written back.

use libration::expression::Equation;
use std::io::{Write, stderr};
use std::sync::Once;

/// Says, once, how a text is understood, unless it is plain.
pub(super) fn say(text: &str) {
    static SAID: Once = Once::new();
    SAID.call_once(|| {
        if let Some(reading) = Equation::read_as(text) {
            // A note that cannot be written is no reason to stop.
            let _ = writeln!(stderr(), "note: the equation is read as {reading}");
        }
    });
}
