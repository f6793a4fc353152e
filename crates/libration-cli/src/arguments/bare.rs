//! Angles without a unit: radians, and a word about it where degrees may be meant.

use libration::quantity::BareRadians;
use std::io::{Write, stderr};

/// Says how the text of an angle, of several or of a range is understood, if that may surprise.
pub(crate) fn say(text: &str) {
    if let Some(doubt) = BareRadians::in_text(text) {
        // A note that cannot be written is no reason to stop.
        let _ = writeln!(stderr(), "note: {doubt}");
    }
}
