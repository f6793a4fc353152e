//! The columns of readings of each quantity.

use super::kinds::Kind;
use super::{ColumnRole, RoleSearch, TableQuantity};
use crate::measurement::counted_periods::counted;
use crate::measurement::heading::Heading;
use crate::measurement::{Choice, CountedPeriods, MeasurementError, Role, Suggestion};
use crate::statistics::{count, mean, median};
use libration::internals::InOrder;

/// Repeated readings of a row are within this factor of each other, in most rows.
const ALIKE: f64 = 1.5;

impl RoleSearch<'_> {
    pub(super) fn assign_readings(&mut self) -> Result<(), MeasurementError> {
        let mut order: Vec<usize> = (0..self.needed.len()).collect();
        order.put_in_order_by(|&quantity| self.needed[quantity].only_named.is_none());
        for quantity in order {
            if self.with_role(ColumnRole::Reading(quantity)).is_empty() {
                let columns = self.named(quantity);
                self.take(quantity, &columns);
            }
        }
        for quantity in 0..self.needed.len() {
            if self.needed[quantity].only_named.is_none()
                && self.with_role(ColumnRole::Reading(quantity)).is_empty()
            {
                let columns = self.first_free(quantity);
                self.take(quantity, &columns);
            }
        }
        let is_missing = |quantity: &usize| {
            self.needed[*quantity].only_named.is_none()
                && self.with_role(ColumnRole::Reading(*quantity)).is_empty()
        };
        let Some(missing) = (0..self.needed.len()).find(is_missing) else { return Ok(()) };
        let name = self.needed[missing].name;
        let needed = self.needed.iter().filter(|quantity| quantity.only_named.is_none()).count();
        if self.numbers() < needed {
            let (names, numbers, words) = (self.names(), self.numbers(), self.words());
            return Err(MeasurementError::TooFewColumns { names, numbers, words });
        }
        Err(MeasurementError::Undecided {
            question: format!("no heading says which column holds the {name}"),
            choices: vec![Suggestion::new(Choice::Role, format!("COLUMN={name}"))],
        })
    }

    /// A clause about the first column of text that a heading says to be needed.
    fn words(&self) -> String {
        let sheet = self.table.sheet();
        let is_needed = |column: &usize| {
            let heading = self.heading(*column);
            let counts = !matches!(counted(&heading.text), CountedPeriods::Nothing);
            counts || self.needed.iter().any(|quantity| quantity.role.is_said_by(heading))
        };
        let candidate =
            (0..self.kinds.len()).filter(|&index| sheet.channels[index].count() == 0).find(is_needed);
        let first = candidate.and_then(|column| Some((column, sheet.channels[column].words().first()?)));
        let clause = |(index, (row, word)): (usize, &(usize, String))| {
            let (line, column) = (sheet.lines[*row], self.describe(index));
            let reason = match () {
                () if word.starts_with('=') => {
                    "a formula without its value: save the table with values in place of formulas"
                }
                () if sheet.dialect.mark.is_missed_in(word) => {
                    "and numbers of other columns have another decimal mark: write all with the same mark"
                }
                () => "which is not read as a number: write it as 1.25, a time as 62.5 or 1:02.5",
            };
            format!("; {column} has `{word}` in line {line}, {reason}")
        };
        first.map(clause).unwrap_or_default()
    }

    fn names(&self) -> String {
        let needed = self.needed.iter().filter(|quantity| quantity.only_named.is_none());
        needed.map(|needed| needed.name).collect::<Vec<_>>().join(" and ")
    }

    /// Number of columns of numbers.
    fn numbers(&self) -> usize {
        self.table.sheet().channels.iter().filter(|channel| channel.count() > 0).count()
    }

    fn take(&mut self, quantity: usize, columns: &[usize]) {
        for &column in columns {
            self.roles[column] = Some(ColumnRole::Reading(quantity));
        }
    }

    /// The columns whose headings name this quantity: the largest set of repeated readings, else means, else squares.
    fn named(&self, quantity: usize) -> Vec<usize> {
        let needed = self.needed[quantity];
        let of_kind = |kind: Kind| -> Vec<usize> {
            let is = |column: &usize| self.roles[*column].is_none() && self.kinds[*column] == kind;
            let says = |column: &usize| {
                says(self.heading(*column), needed, kind) || self.is_only_angle(*column, needed)
            };
            (0..self.kinds.len()).filter(is).filter(says).collect()
        };
        let sets = self.repeated(&of_kind(Kind::Values));
        let largest = sets.iter().map(Vec::len).max().unwrap_or(0);
        let values = sets.into_iter().find(|set| set.len() == largest);
        let other = || {
            let single = |kind| of_kind(kind).first().map(|&column| vec![column]);
            single(Kind::Means).or_else(|| single(Kind::Squares).filter(|_| needed.role == Role::Times))
        };
        values.or_else(other).unwrap_or_default()
    }

    /// Returns `true` if a unit shows that a column contains angles, and this is the only quantity of angles.
    fn is_only_angle(&self, column: usize, needed: TableQuantity) -> bool {
        let of_angles =
            |quantity: &&TableQuantity| matches!(quantity.role, Role::Angles | Role::Displacements);
        let heading = self.heading(column);
        needed.role == Role::Angles
            && self.needed.iter().filter(of_angles).count() == 1
            && heading.unit.is_some()
            && Role::Angles.is_said_by(heading)
    }

    /// The first free column of values, with its repetitions; a column with the heading of another quantity only if there are no others.
    fn first_free(&self, quantity: usize) -> Vec<usize> {
        let free: Vec<usize> = (0..self.kinds.len()).filter(|&column| self.is_free(column)).collect();
        let says_other = |column: &usize| {
            let heading = self.heading(*column);
            heading.unit.is_some() && self.needed[quantity].role.contradicted_by(heading).is_some()
        };
        let fitting: Vec<usize> = free.iter().copied().filter(|column| !says_other(column)).collect();
        let sets = self.repeated(if fitting.is_empty() { &free } else { &fitting });
        sets.into_iter().next().unwrap_or_default()
    }

    /// The columns as sets of repeated readings, in the order of their first columns. A column of zeros, which does not even agree with itself, is
    /// not compared with others: a hostile table may have thousands.
    fn repeated(&self, columns: &[usize]) -> Vec<Vec<usize>> {
        let name = |&column: &usize| (stem(self.heading(column)), self.heading(column).unit);
        let names: Vec<_> = columns.iter().map(name).collect();
        let mut sets: Vec<(usize, Vec<usize>)> = vec![];
        for (index, &column) in columns.iter().enumerate() {
            let is_of = |(first, _): &&mut (usize, Vec<usize>)| {
                names[*first] == names[index] && self.agree(columns[*first], column)
            };
            let same = if self.agree(column, column) { sets.iter_mut().find(is_of) } else { None };
            match same {
                Some((_, set)) => set.push(column),
                None => sets.push((index, vec![column])),
            }
        }
        sets.into_iter().map(|(_, set)| set).collect()
    }

    /// Returns `true` if two columns have values within a factor of each other.
    fn agree(&self, one: usize, other: usize) -> bool {
        self.ratio(&[one], other).is_some_and(|ratio| (1.0 / ALIKE..ALIKE).contains(&ratio))
    }

    /// The median ratio of the mean of these columns to another one.
    fn ratio(&self, columns: &[usize], other: usize) -> Option<f64> {
        median(self.ratios(columns, other))
    }

    fn ratios(&self, columns: &[usize], other: usize) -> Vec<f64> {
        let sheet = self.table.sheet();
        let number = |column: usize, row: usize| sheet.number(column, row).ok().flatten();
        let ratio = |row: usize| {
            let values: Vec<f64> = columns.iter().filter_map(|&column| number(column, row)).collect();
            let quotient = mean(values.iter().copied()) / number(other, row)?;
            Some(quotient).filter(|value| value.is_finite())
        };
        (0..sheet.rows()).filter_map(ratio).collect()
    }

    /// The number of swings of each reading, if another column is their mean divided by a whole number from two on, within a hundredth in each row.
    pub(super) fn swings_by_a_quotient(&self, readings: &[usize]) -> Option<f64> {
        const WITHIN: f64 = 0.01;
        let first = self.heading(*readings.first()?);
        let is_open = |column: &usize| self.roles[*column].is_none() && self.kinds[*column] != Kind::Other;
        let is_time = |column: &usize| {
            // `T = t/10` next to `t (s)`
            let heading = self.heading(*column);
            let counts = heading.unit.is_none() && !matches!(counted(&heading.text), CountedPeriods::Nothing);
            counts || Role::Times.is_said_by(heading) && heading.unit == first.unit
        };
        if !Role::Times.is_said_by(first) {
            return None;
        }
        (0..self.kinds.len()).filter(is_open).filter(is_time).find_map(|column| {
            let ratios = self.ratios(readings, column);
            let whole = median(ratios.clone())?.round();
            let is_near = |ratio: &f64| (ratio / whole - 1.0).abs() < WITHIN;
            (whole >= 2.0 && ratios.len() > 1 && ratios.iter().all(is_near)).then_some(whole)
        })
    }

    /// Number of readings in each row, at most.
    pub(super) fn readings_of(&self, quantity: usize) -> f64 {
        count(self.with_role(ColumnRole::Reading(quantity)).len())
    }
}

/// Returns `true` if a heading names this quantity, or its squares.
fn says(heading: &Heading, needed: TableQuantity, kind: Kind) -> bool {
    let name = heading.name.to_lowercase();
    if let Some(beginnings) = needed.only_named {
        return beginnings.iter().any(|beginning| name.starts_with(beginning));
    }
    match kind {
        Kind::Squares => ["t", "period", "time"].iter().any(|symbol| name.starts_with(symbol)),
        _ => {
            needed.role.is_said_by(heading)
                || needed.role == Role::Times
                    && heading.unit.is_none()
                    && heading.unit_text.is_none()
                    && matches!(counted(&heading.text), CountedPeriods::Said(_))
        }
    }
}

/// Words before the letter or the number of a reading.
const READING: [&str; 25] = [
    "run",
    "trial",
    "reading",
    "measurement",
    "attempt",
    "try",
    "versuch",
    "messung",
    "essai",
    "prova",
    "ensaio",
    "tentativa",
    "medição",
    "medición",
    "intento",
    "medida",
    "misura",
    "mesure",
    "poging",
    "meting",
    "försök",
    "mätning",
    "próba",
    "pomiar",
    "durchgang",
];

/// The name of a column without the number of the reading: `t 1`, `t_2`, `3rd trial`, `2. Versuch`, `run B`, `T (3)`.
fn stem(heading: &Heading) -> String {
    let subscript = |letter: char| match letter {
        '₀'..='₉' => '0',
        other => other,
    };
    let plain: String = heading
        .name
        .to_lowercase()
        .chars()
        .filter(|character| !"{}#()".contains(*character))
        .map(subscript)
        .collect();
    let mut words: Vec<&str> = plain.split([' ', '_']).filter(|word| !word.is_empty()).collect();
    let is_ordinal = |word: &str| {
        let digits = word.trim_end_matches(|letter: char| letter.is_alphabetic() || ".°".contains(letter));
        !digits.is_empty()
            && digits.bytes().all(|byte| byte.is_ascii_digit())
            && ["st", "nd", "rd", "th", ".", "°", "º", "ª", "e", "er", "ère"].contains(&&word[digits.len()..])
    };
    words.retain(|word| !is_ordinal(word));
    if let [.., before, last] = words[..]
        && last.chars().count() == 1
        && READING.contains(&before)
    {
        words.pop();
    }
    words
        .join(" ")
        .trim_end_matches(|letter: char| letter.is_ascii_digit() || letter == ' ' || letter == '.')
        .to_owned()
}
