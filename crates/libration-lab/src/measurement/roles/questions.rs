//! Tables that may be read in several ways, each refused with the choices that would decide.

use super::{ColumnRole, GivenRoles, RoleSearch};
use crate::measurement::counted_periods::{SwingNumbers, swing_numbers};
use crate::measurement::heading::Heading;
use crate::measurement::heading::words::is_deviation;
use crate::measurement::{Choice, MeasurementError, Role, Suggestion};

impl RoleSearch<'_> {
    /// Two tables side by side have the same names again, in the same order.
    pub(super) fn refuse_tables_side_by_side(&self) -> Result<(), MeasurementError> {
        let values: Vec<usize> = (0..self.kinds.len()).filter(|&column| self.is_free(column)).collect();
        let name = |column: &usize| self.heading(*column).name.to_lowercase();
        let Some((first, rest)) = values.split_first() else { return Ok(()) };
        let Some(again) =
            rest.iter().position(|column| !name(first).is_empty() && name(column) == name(first))
        else {
            return Ok(());
        };
        let (left, right) = values.split_at(again + 1);
        let is_other = left.len() > 1 && left.len() == right.len();
        if !is_other || !left.iter().zip(right).all(|(left, right)| name(left) == name(right)) {
            return Ok(());
        }
        let columns = |indices: &[usize]| {
            let numbers: Vec<String> = indices.iter().map(|column| (column + 1).to_string()).collect();
            Suggestion::new(Choice::Columns, numbers.join(","))
        };
        Err(MeasurementError::Undecided {
            question: format!(
                "two tables stand side by side, the second from {} on",
                self.describe(right[0])
            ),
            choices: vec![columns(left), columns(right)],
        })
    }

    /// `T max` and `T min` are no readings: the value is between them.
    pub(super) fn refuse_bounds(&self) -> Result<(), MeasurementError> {
        let free = || (0..self.kinds.len()).filter(|&column| self.is_free(column));
        let bound = |column: usize| bound(self.heading(column));
        let bounds = free().find_map(|high| {
            let (name, _) = bound(high).filter(|(_, is_most)| *is_most)?;
            let low = free().find(|&low| bound(low) == Some((name.clone(), false)))?;
            Some(([high, low], Heading::read(&name, None, None)))
        });
        let Some((pair, plain)) = bounds else { return Ok(()) };
        let said = |quantity: &&super::TableQuantity| {
            quantity.only_named.is_none()
                && [self.heading(pair[0]), &plain].iter().any(|heading| quantity.role.is_said_by(heading))
        };
        let Some(quantity) = self.needed.iter().find(said) else { return Ok(()) };
        let [high, low] = pair.map(|column| self.describe(column));
        let choice =
            |column: usize| Suggestion::new(Choice::Role, format!("{}={}", column + 1, quantity.name));
        Err(MeasurementError::Undecided {
            question: format!(
                "{high} and {low} are bounds of the {}: put their middle and a column of half-widths, (max − min)/2, in their place, or \
                 take one bound for the value",
                quantity.name
            ),
            choices: pair.map(choice).to_vec(),
        })
    }

    /// `peak-to-peak (deg)` is twice the amplitude, `rms amplitude` that of a sine over √2.
    pub(super) fn refuse_full_swings(&self) -> Result<(), MeasurementError> {
        const FULL: [&str; 12] = [
            "peak-to-peak",
            "peak to peak",
            "pk-pk",
            "p-p",
            "double amplitude",
            "full amplitude",
            "total angle",
            "side to side",
            "doppelte amplitude",
            "spitze-spitze",
            "crête à crête",
            "de pico a pico",
        ];
        const SQUARES: [&str; 4] = ["r.m.s.", "root mean square", "root-mean-square", "effektivwert"];
        let not_an_amplitude = |column: usize| {
            let name = self.heading(column).name.to_lowercase();
            let has = |notations: &[&str]| notations.iter().any(|words| name.contains(words));
            let is_square = || {
                has(&SQUARES)
                    || name.split(|letter: char| !letter.is_alphanumeric()).any(|word| word == "rms")
            };
            match () {
                () if has(&FULL) => Some((column, ["twice the", "halve its numbers"])),
                () if is_square() => {
                    Some((column, ["a root mean square, 1/√2 of the", "multiply its numbers by √2"]))
                }
                () => None,
            }
        };
        let is_amplitude =
            |quantity: &&super::TableQuantity| matches!(quantity.role, Role::Angles | Role::Displacements);
        let candidate =
            (0..self.kinds.len()).filter(|&column| self.is_free(column)).find_map(not_an_amplitude);
        let (Some((column, [what, remedy])), Some(quantity)) =
            (candidate, self.needed.iter().find(is_amplitude))
        else {
            return Ok(());
        };
        Err(MeasurementError::Undecided {
            question: format!(
                "{} is {what} {} by its heading: {remedy} and rename it, or take them as they are",
                self.describe(column),
                quantity.name
            ),
            choices: vec![Suggestion::new(Choice::Role, format!("{}={}", column + 1, quantity.name))],
        })
    }

    /// Refuses a column `N` or `Anzahl` next to periods, which is as often the number of readings as that of swings.
    pub(super) fn refuse_counts_of_periods(&self, given: &GivenRoles) -> Result<(), MeasurementError> {
        let Some(&column) = self.with_role(ColumnRole::Swings).first() else { return Ok(()) };
        let is_given = given.are_all || given.roles.iter().any(|(_, role)| *role == ColumnRole::Swings);
        let is_bare = swing_numbers(&self.heading(column).text) == SwingNumbers::Possible;
        let counts_more = self.table.sheet().channels[column].numbers().flatten().any(|number| number > 1.0);
        let is_scatter = |other: usize| {
            let of = self.roles[other];
            matches!(of, Some(ColumnRole::Uncertainty(..))) && is_deviation(&self.heading(other).text)
        };
        let has_scatter = (0..self.kinds.len()).any(is_scatter);
        if is_given || !is_bare || !counts_more || !(self.has_named_periods() || has_scatter) {
            return Ok(());
        }
        let choice = |role: &str| Suggestion::new(Choice::Role, format!("{}={role}", column + 1));
        Err(MeasurementError::Undecided {
            question: format!(
                "{} may be the number of swings that each time lasts, or that of readings",
                self.describe(column)
            ),
            choices: ["swings", if has_scatter { "readings" } else { "ignore" }].map(choice).to_vec(),
        })
    }
}

/// The name of a quantity whose largest or smallest value a heading names, and `true` for the largest.
fn bound(heading: &Heading) -> Option<(String, bool)> {
    const WORDS: [(&str, bool); 8] = [
        ("maximum", true),
        ("minimum", false),
        ("max.", true),
        ("min.", false),
        ("max", true),
        ("min", false),
        ("upper", true),
        ("lower", false),
    ];
    let name = heading.name.to_lowercase();
    WORDS.iter().find_map(|(word, is_most)| {
        let rest = name.strip_suffix(word).or_else(|| name.strip_prefix(word))?;
        let rest = rest.trim_matches(|letter: char| " _-{}()".contains(letter));
        (!rest.is_empty()).then(|| (rest.to_owned(), *is_most))
    })
}

/// Returns `true` for `T`, `T1`, `period`: the time of a single swing.
pub(super) fn is_named_period(heading: &Heading) -> bool {
    let symbol =
        heading.name.trim_end_matches(|letter: char| letter.is_ascii_digit() || "_ {}".contains(letter));
    symbol == "T" || heading.name.to_lowercase().starts_with("period")
}
