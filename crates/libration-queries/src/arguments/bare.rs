//! Angles without a unit: radians, and a word about it where degrees may be meant.

use crate::call;
use libration::quantity::BareRadians;

/// Says how the text of an angle, of several or of a range is understood, if that may surprise.
pub(crate) fn say(text: &str) {
    if let Some(doubt) = BareRadians::in_text(text) {
        call::current().note(&doubt.to_string());
    }
}
