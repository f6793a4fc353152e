//! Uncertainties in a heading: of all values of its column, `T (s) ± 0.004`, or relative ones of another column, `u(T) in %`.

use super::{Heading, Unit, split_unit};

/// Uncertainty of all values of a column, stated in its heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedUncertainty {
    /// The number, in `unit`, or as a fraction of the values.
    pub value: f64,
    /// The unit; that of the column if `None`.
    pub unit: Option<Unit>,
    /// `true` if it is a fraction of the values.
    pub is_relative: bool,
}

/// Signs and words of fractions.
const FRACTIONS: [(&str, f64); 7] = [
    ("%", 0.01),
    ("‰", 0.001),
    ("percent", 0.01),
    ("per cent", 0.01),
    ("prozent", 0.01),
    ("promille", 0.001),
    ("ppm", 1e-6),
];

/// Divides a heading into the text without `± number` and the uncertainty that this states.
pub(in crate::measurement) fn without_stated(text: &str) -> (String, Option<StatedUncertainty>) {
    let parts = text.split_once('±').and_then(|(before, after)| {
        let after = after.trim_start();
        let end = after
            .find(|letter: char| !(letter.is_ascii_digit() || ".,".contains(letter)))
            .unwrap_or(after.len());
        let value: f64 = after[..end].trim_end_matches(['.', ',']).replace(',', ".").parse().ok()?;
        Some((before, value, &after[end..])).filter(|_| value > 0.0 && value.is_finite())
    });
    let Some((before, value, rest)) = parts else { return (text.to_owned(), None) };
    let fraction =
        FRACTIONS.iter().find_map(|(sign, size)| Some((rest.trim_start().strip_prefix(sign)?, *size)));
    if let Some((rest, size)) = fraction {
        let stated = StatedUncertainty { value: value * size, unit: None, is_relative: true };
        return (joined(before, rest), Some(stated));
    }
    // After a unit of the column the number has one of its own: `T (s) ± 4 ms`.
    let has_unit =
        split_unit(before.trim()).1.is_some_and(|unit| !unit.trim().is_empty() && before.contains(')'));
    let unit_text =
        rest.trim_start().split([' ', ')', ']', ',']).next().filter(|_| has_unit).unwrap_or_default();
    let unit: Option<Unit> = unit_text.parse().ok();
    let rest = if unit.is_some() { &rest.trim_start()[unit_text.len()..] } else { rest };
    (joined(before, rest), Some(StatedUncertainty { value, unit, is_relative: false }))
}

/// The text around a number that was taken out, without empty brackets.
fn joined(before: &str, after: &str) -> String {
    let (before, after) = (before.trim_end_matches([' ', ',', ';']), after.trim_start_matches([',', ';']));
    let text = match (before.strip_suffix(['(', '[']), after.trim_start().strip_prefix([')', ']'])) {
        (Some(before), Some(after)) => format!("{before} {after}"),
        // `(L ± 0.2) cm`
        _ if before.starts_with('(') && after.starts_with(')') => format!("{}{}", &before[1..], &after[1..]),
        _ if after.starts_with([')', ']']) => format!("{before}{after}"),
        _ => format!("{before} {after}"),
    };
    text.trim().to_owned()
}

impl Heading {
    /// The fraction of the quantity to which 1 in the column corresponds, if the heading states it: 0.01 for `u(T) in %`. A number before the sign
    /// is a level of confidence.
    pub(in crate::measurement) fn fraction(&self) -> Option<f64> {
        let lower = self.text.to_lowercase();
        FRACTIONS.iter().find_map(|(sign, size)| {
            let before = &lower[..lower.find(sign)?];
            (!before.trim_end().ends_with(|letter: char| letter.is_ascii_digit())).then_some(*size)
        })
    }

    /// Returns `true` if the heading speaks of relative uncertainties and not of their unit.
    pub(in crate::measurement) fn is_relative_without_unit(&self) -> bool {
        let lower = self.text.to_lowercase();
        let says = ["relativ", "rel.", "rel ", "fractional"].iter().any(|word| lower.contains(word));
        says && self.fraction().is_none() && self.unit.is_none()
    }
}
