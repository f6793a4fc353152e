//! Number of periods that each time of a column lasts, by its heading: `10T`, `half period (s)`, `time of 20 oscillations`.

use super::table::Table;
use super::{Column, MeasurementError};

/// Number of periods that each time lasts, as stated in a heading.
#[derive(Clone, Debug, PartialEq)]
pub enum CountedPeriods {
    /// The stated number: 0.5 for half periods, 1 where the heading speaks of a period or of T.
    Said(f64),
    /// No number is stated.
    Nothing,
    /// A number or a part that may be meant so, as in `T10` or `10 swings`: the heading as it is written.
    Unclear(String),
}

impl Table {
    /// Number of periods that each time in this column lasts, by its heading.
    ///
    /// # Errors
    /// No such column.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, CountedPeriods, ReadOptions, Table};
    ///
    /// let table = Table::read(b"L (m),10 T (s)\n0.25,10.0\n0.50,14.2\n", &ReadOptions::default())?;
    /// assert_eq!(table.counted_periods(&Column::Number(2))?, CountedPeriods::Said(10.0));
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    pub fn counted_periods(&self, column: &Column) -> Result<CountedPeriods, MeasurementError> {
        let sheet = self.sheet();
        let heading = &sheet.channels[sheet.place(column)?].heading;
        let text = heading.text.as_str();
        let run = heading.run.as_deref().unwrap_or_default();
        Ok(counted(text.strip_suffix(run).unwrap_or(text)))
    }
}

/// Words for one period, in the singular and the plural.
const PERIOD: [&str; 23] = [
    "t",
    "period",
    "periods",
    "periode",
    "perioden",
    "période",
    "périodes",
    "periodo",
    "periodi",
    "periodos",
    "oscillation",
    "oscillations",
    "oscillazioni",
    "oscilaciones",
    "schwingung",
    "schwingungen",
    "schwingungsdauer",
    "schwingungsdauern",
    "cycles",
    "cycle",
    "swings",
    "swing",
    "osc",
];
/// Words that are a count where a number stands before them, and otherwise as often half a period.
const SWING: [&str; 2] = ["swings", "swing"];
const HALF: [&str; 8] = ["half", "halbe", "halben", "demi", "semi", "½", "0.5", "0,5"];
const HALF_PERIOD: [&str; 4] = ["halfperiod", "semiperiodo", "semiperiod", "halbschwingung"];
/// Words for a mean: the mean of several periods is one period.
const MEAN: [&str; 12] = [
    "mean",
    "average",
    "avg",
    "averaged",
    "mittel",
    "mittelwert",
    "gemittelt",
    "mittlere",
    "moyenne",
    "media",
    "medio",
    "per",
];

/// Number of periods that a column with this heading counts in each time.
pub fn counted(heading: &str) -> CountedPeriods {
    let lower = heading.to_lowercase().replace(['×', '*', '·', '_', '-', '{', '}', '$'], " ");
    let words = words(&lower);
    let is = |list: &[&str], word: &String| list.contains(&word.as_str());
    let followed_by_period = |place: usize| words.get(place + 1).is_some_and(|next| is(&PERIOD, next));
    let is_half = words
        .iter()
        .enumerate()
        .any(|(place, word)| is(&HALF_PERIOD, word) || is(&HALF, word) && followed_by_period(place));
    let is_halved = words.windows(3).any(|three| three[0] == "t" && three[1] == "/" && three[2] == "2");
    if is_half || is_halved {
        return CountedPeriods::Said(0.5);
    }
    let number =
        |word: &String| word.parse::<f64>().ok().filter(|number| *number > 0.0 && number.is_finite());
    let count = |(place, word): (usize, &String)| number(word).filter(|_| followed_by_period(place));
    let is_mean = words.iter().any(|word| is(&MEAN, word));
    let is_divided = words.windows(2).any(|pair| pair[0] == "/" && number(&pair[1]).is_some());
    match words.iter().enumerate().find_map(count) {
        Some(count) if !is_mean && !is_divided => return CountedPeriods::Said(count),
        Some(_) => return CountedPeriods::Unclear(heading.trim().to_owned()),
        None => {}
    }
    // Smaller numbers behind a symbol number the trials.
    let may_count = |word: &String| is(&HALF, word) || number(word).is_some_and(|number| number >= 10.0);
    if is_divided || words.iter().any(may_count) {
        return CountedPeriods::Unclear(heading.trim().to_owned());
    }
    if words.iter().any(|word| is(&PERIOD, word) && !is(&SWING, word)) {
        CountedPeriods::Said(1.0)
    } else {
        CountedPeriods::Nothing
    }
}

/// Returns whether a heading speaks of a mean.
pub(super) fn is_mean(heading: &str) -> bool {
    words(&heading.to_lowercase()).iter().any(|word| word != "per" && MEAN.contains(&word.as_str()))
}

/// Letters, numbers and strokes, each on its own: `10T/s` is `10`, `t`, `/`, `s`.
fn words(text: &str) -> Vec<String> {
    let kind = |letter: char| match letter {
        '0'..='9' | '.' | ',' => 1,
        letter if letter.is_alphabetic() => 2,
        '/' | '½' => 3,
        _ => 0,
    };
    let letters: Vec<char> = text.chars().collect();
    let pieces = letters.chunk_by(|&a, &b| kind(a) == kind(b) && kind(a) != 3);
    pieces.filter(|piece| kind(piece[0]) != 0).map(|piece| piece.iter().collect()).collect()
}
