//! Angles without a unit, which are radians and may have been meant as degrees.

use std::f64::consts::{PI, TAU};
use std::fmt;

/// A number without a unit that is taken as radians and is more than half a turn.
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
    /// As it is written.
    written: String,
    radians: f64,
}

impl BareRadians {
    /// The first of the numbers in the text of an angle, of several angles, or of a range.
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
        // Four digits are enough to be surprised by.
        let digits = if turns.abs() < 1000.0 { 3 } else { 0 };
        write!(formatter, "taken as {written} rad = {turns:.digits$} turns; for degrees write {written}deg")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_bare_numbers_above_half_a_turn_are_doubted() {
        let said = |text: &str| BareRadians::in_text(text).map(|doubt| doubt.to_string());
        assert_eq!(said("-60").unwrap(), "taken as -60 rad = -9.549 turns; for degrees write -60deg");
        assert_eq!(said("1e5").unwrap(), "taken as 1e5 rad = 15915 turns; for degrees write 1e5deg");
        assert!(said("30deg,3.2").unwrap().starts_with("taken as 3.2 rad"));
        assert!(said("1:179:1").unwrap().starts_with("taken as 179 rad"));
        let [below, above] = [PI, PI.next_up()].map(|angle| said(&format!("{angle:?}")));
        assert!(below.is_none() && above.is_some());
        for clear in ["60deg", "60rad", "20pi", "pi-1e-6", "60 deg", "", "sixty", "inf", "200deg-1deg"] {
            assert_eq!(said(clear), None, "{clear}");
        }
    }
}
