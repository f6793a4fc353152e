//! Angles without a unit: they are radians, but may have been meant as degrees.

use std::f64::consts::{PI, TAU};
use std::fmt;

/// A number without a unit that is interpreted as radians and exceeds half a turn.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::BareRadians;
/// let doubt = BareRadians::in_text("60").unwrap();
/// assert_eq!(doubt.to_string(), "taken as 60 rad = 9.549 turns; for degrees write 60deg");
/// assert_eq!(BareRadians::in_text("60deg"), None);
/// assert_eq!(BareRadians::in_text("3.1"), None);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BareRadians {
    /// The number as written.
    written: String,
    radians: f64,
}

impl BareRadians {
    /// The first such number in the text of an angle, of several angles, or of a range.
    #[must_use]
    pub fn in_text(text: &str) -> Option<Self> {
        let parts = text.split([',', ':']).map(str::trim);
        let doubtful = |written: &str| {
            let radians: f64 = written.replace('−', "-").parse().ok()?;
            let more = radians.is_finite() && radians.abs() > PI;
            more.then(|| Self { written: written.to_owned(), radians })
        };
        parts.filter_map(doubtful).next()
    }
}

impl fmt::Display for BareRadians {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { written, radians } = self;
        let turns = radians / TAU;
        // Four digits are enough to draw attention.
        let digits = if turns.abs() < 1000.0 { 3 } else { 0 };
        write!(formatter, "taken as {written} rad = {turns:.digits$} turns; for degrees write {written}deg")
    }
}
