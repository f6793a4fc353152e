//! Names that contain the name of another column: uncertainties, `dT` next to `T`, `xerr` next to `x`, and minima, `T_min` next to `T_max`.

use super::{Heading, Unit};

/// Marks of an uncertainty before a name.
const BEFORE: [&str; 8] = ["d", "Δ", "∆", "δ", "delta", "u", "σ", "sigma"];
/// Marks of an uncertainty after a name, in lower case.
const AFTER: [&str; 8] = ["err", "error", "unc", "uncert", "sd", "std", "stdev", "sigma"];

/// Marks the headings whose names are a sign of uncertainty and the name of another column of the same unit. `distance`, `diameter` and a single
/// `d` are not uncertainties.
pub(in crate::measurement) fn name_uncertainties(headings: &mut [Heading]) {
    for index in 0..headings.len() {
        if headings[index].is_uncertainty {
            continue;
        }
        let of = stems(&headings[index].name).into_iter().find_map(|stem| {
            let is_of = |other: &&Heading| other.name == stem && headings[index].may_measure_as(other);
            headings.iter().filter(|other| !other.is_uncertainty).find(is_of)
        });
        if let Some((name, quantity)) = of.map(|of| (of.name.clone(), of.quantity)) {
            let heading = &mut headings[index];
            (heading.is_uncertainty, heading.uncertainty_of, heading.quantity) = (true, Some(name), quantity);
        }
    }
}

/// Corrects headings that were read as quantities in minutes but are minima, since another heading is equal except for `max`.
pub(in crate::measurement) fn name_minima(headings: &mut [Heading]) {
    for index in 0..headings.len() {
        let text = headings[index].text.to_lowercase();
        let Some(stem) = text.strip_suffix("min").filter(|_| headings[index].unit == Some(Unit::Minute))
        else {
            continue;
        };
        let maximum = headings.iter().find(|other| other.text.to_lowercase() == format!("{stem}max"));
        if let Some(quantity) = maximum.map(|maximum| maximum.quantity) {
            let heading = &mut headings[index];
            let name = heading.text.clone();
            (heading.name, heading.quantity, heading.unit, heading.unit_text) = (name, quantity, None, None);
        }
    }
}

/// Parts of a name that remain without a sign of uncertainty before or after it.
fn stems(name: &str) -> Vec<&str> {
    let between = [' ', '_', '-', '.'];
    let before = BEFORE.iter().filter_map(|sign| name.strip_prefix(sign));
    let after = AFTER.iter().filter_map(|sign| {
        let (stem, end) = name.split_at_checked(name.len().checked_sub(sign.len())?)?;
        end.eq_ignore_ascii_case(sign).then_some(stem)
    });
    let stems = before.chain(after).map(|stem| stem.trim_matches(between));
    stems.filter(|stem| !stem.is_empty()).collect()
}

impl Heading {
    /// Returns `true` if the unit is of the same kind as that of another column, or the column has no unit.
    fn may_measure_as(&self, other: &Self) -> bool {
        match (self.unit, other.unit) {
            (Some(unit), Some(other)) => unit.measures() == other.measures(),
            (None, _) => self.unit_text.is_none() || self.unit_text == other.unit_text,
            (Some(_), None) => false,
        }
    }
}
