//! Angles without a unit: radians, with a note if degrees may be meant.

use crate::call;
use libration::quantity::BareRadians;

/// Writes a note on the unit of an angle, of several or of a range, if degrees may be meant.
pub(crate) fn say(text: &str) {
    if let Some(doubt) = BareRadians::in_text(text) {
        call::current().note(&doubt.to_string());
    }
}
