//! Columns that are parts of one quantity: `t (min)` and `t (s)`, `L (ft)` and `L (in)`.

use super::Unit;
use super::heading::Heading;
use super::number::Cell;
use super::sheet::Sheet;

/// A unit, the smaller one in which the rest is written, and the number of those in it.
const PAIRS: [(Unit, Unit, f64); 2] = [(Unit::Minute, Unit::Second, 60.0), (Unit::Foot, Unit::Inch, 12.0)];

impl Sheet {
    /// Adds whole minutes or feet to the seconds or inches in the next column, where all of these are less than one of those.
    pub(super) fn join_parts(&mut self) {
        for column in 1..self.channels.len() {
            let Some(parts) = self.parts(column) else {
                self.remarks.extend(self.unread_part(column));
                continue;
            };
            let text = format!(
                "{} and {} are {} and {} of one quantity, and are added",
                self.describe(column - 1),
                self.describe(column),
                parts.units[0],
                parts.units[1]
            );
            self.remarks.push(text);
            let [whole, rest] = &mut self.channels[column - 1..=column] else { continue };
            rest.cells = parts.sums;
            let name = own_name(&whole.heading);
            if own_name(&rest.heading).is_empty() && !name.is_empty() {
                rest.heading = Heading::read(format!("{name} ({})", parts.units[1]).trim(), None, None);
            }
            rest.heading.set_unit(parts.units[1]);
            whole.cells.fill(Cell::Missing);
        }
    }

    /// A remark on a column that is not added to the one before it because of a cell that is not a number.
    fn unread_part(&self, column: usize) -> Option<String> {
        self.factor(column)?;
        let (_, word) = self.channels[column].words.first()?;
        let [whole, rest] = [column - 1, column].map(|index| self.describe(index));
        Some(format!("{rest} is not added to {whole}, since `{word}` is not read as a number"))
    }

    /// The number of units of a column in that of the column before it, if their headings are those of parts of one quantity.
    fn factor(&self, column: usize) -> Option<f64> {
        let [whole, rest] = &self.channels[column - 1..=column] else { return None };
        let units = [whole, rest].map(|channel| unit(&channel.heading));
        let (_, _, factor) = PAIRS.into_iter().find(|(one, other, _)| units == [Some(*one), Some(*other)])?;
        let names = [whole, rest].map(|channel| own_name(&channel.heading).to_lowercase());
        (names[1].is_empty() || names[0] == names[1]).then_some(factor)
    }

    /// The sums of a column and the one before it, if these are parts of one quantity.
    fn parts(&self, column: usize) -> Option<Parts> {
        let factor = self.factor(column)?;
        let [whole, rest] = &self.channels[column - 1..=column] else { return None };
        let units = [whole, rest].map(|channel| unit(&channel.heading));
        let is_part = |channel: &super::Channel| {
            !channel.heading.is_uncertainty && channel.words.is_empty() && channel.count() > 0
        };
        if !(is_part(whole) && is_part(rest)) {
            return None;
        }
        let sum = |(whole, rest): (&Cell, &Cell)| match (whole, rest) {
            (Cell::Number(whole), Cell::Number(rest)) => {
                let are_parts = *whole >= 0.0 && whole.fract() == 0.0 && (0.0..factor).contains(rest);
                are_parts.then_some(Cell::Number(factor * whole + rest))
            }
            (Cell::Missing, rest @ Cell::Number(_)) => Some(*rest),
            (_, Cell::Missing) => Some(Cell::Missing),
            _ => None,
        };
        let sums = whole.cells.iter().zip(&rest.cells).map(sum).collect::<Option<Vec<Cell>>>()?;
        Some(Parts { units: [units[0]?, units[1]?], sums })
    }
}

/// Two units, and the sums in the smaller one.
struct Parts {
    units: [Unit; 2],
    sums: Vec<Cell>,
}

/// The unit of a column, which may be all of its name.
fn unit(heading: &Heading) -> Option<Unit> {
    heading.unit.or_else(|| heading.text.parse().ok())
}

/// The name of a column without its unit.
fn own_name(heading: &Heading) -> &str {
    let is_unit = heading.unit.is_none() && heading.text.parse::<Unit>().is_ok();
    if is_unit { "" } else { heading.name.trim() }
}
