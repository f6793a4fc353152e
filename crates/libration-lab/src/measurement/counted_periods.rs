//! Number of periods that each time of a column lasts, by its heading: `10T`, `half period (s)`, `time of 20 oscillations`.

use super::heading::without_stated;
use super::numbered_time;
use super::table::Table;
use super::words::{UNITS_OF_TIME, is, number, words};
use super::{Column, MeasurementError};

/// Number of periods that each time lasts, as stated in a heading.
#[derive(Clone, Debug, PartialEq)]
pub enum CountedPeriods {
    /// The stated number: 0.5 for half periods, 1 where the heading speaks of a period or of T.
    Said(f64),
    /// A number from two on after the symbol of a time, as in `T5`: the number of periods, or that of a reading.
    Numbered(f64),
    /// No number is stated.
    Nothing,
    /// A number or a part that may be meant as a number of periods, as in `T10` or `10 swings`: the heading as written.
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
        let index = sheet.index_of(column)?;
        let heading = &sheet.channels[index].heading;
        let text = match heading.stated_uncertainty {
            Some(_) => &without_stated(&heading.text.replace("+/-", "±").replace("+-", "±")).0,
            None => &heading.text,
        };
        let of_heading = counted_in(text, heading.run.as_deref().unwrap_or_default());
        Ok(match numbered_time::number(text) {
            Some(_) if numbered_time::is_of_reading(self, index) => counted(numbered_time::symbol(text)),
            Some(number) if number > 1.0 => CountedPeriods::Numbered(number),
            _ => of_heading,
        })
    }
}

/// Words for one period, in the singular and the plural.
const PERIOD: [&str; 92] = [
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
    "período",
    "períodos",
    "oscillation",
    "oscillations",
    "oscillazione",
    "oscillazioni",
    "oscilación",
    "oscilaciones",
    "schwingung",
    "schwingungen",
    "vollschwingung",
    "vollschwingungen",
    "pendelschwingungen",
    "schwingungsdauer",
    "schwingungsdauern",
    "cycles",
    "cycle",
    "swings",
    "swing",
    "osc",
    "oscs",
    "vibration",
    "vibrations",
    "periodendauer",
    "oscilacion",
    "oscilação",
    "oscilações",
    "oscilacoes",
    "okres",
    "okresy",
    "okresów",
    "drgań",
    "wahań",
    "wahnięć",
    "wahnięcia",
    "periodes",
    "perioder",
    "slingertijd",
    "slingering",
    "slingeringen",
    "trilling",
    "trillingen",
    "trillingstijd",
    "trillingstijden",
    "svängning",
    "svängningar",
    "svängningstid",
    "schw",
    "pendelbewegungen",
    "svingning",
    "svingninger",
    "svingningstid",
    "heilahdusta",
    "heilahduksen",
    "heilahdusaika",
    "kmit",
    "kmity",
    "kmitů",
    "kmitov",
    "perioda",
    "lengés",
    "lengésidő",
    "salınım",
    "periyot",
    "ταλάντωση",
    "ταλαντώσεις",
    "ταλαντώσεων",
    "περίοδος",
    "колебание",
    "колебания",
    "колебаний",
    "период",
    "коливання",
    "коливань",
    "період",
    "oscilație",
    "oscilații",
    "perioadă",
    "titraja",
    "nihajev",
    "ayunan",
    "oscil",
];
/// Words that are a count after a number, and otherwise as often half a period.
const SWING: [&str; 2] = ["swings", "swing"];
const HALF: [&str; 9] = ["half", "halbe", "halben", "halber", "demi", "semi", "mezza", "mezze", "½"];
const HALF_PERIOD: [&str; 11] = [
    "halfperiod",
    "halfperiods",
    "semiperiodo",
    "semiperiodi",
    "semiperiodos",
    "semiperiod",
    "halbschwingung",
    "halbschwingungen",
    "halbperiode",
    "halbperioden",
    "halbschwingungsdauer",
];
/// Words between a number and the periods that it counts.
const BETWEEN: [&str; 35] = [
    "complete",
    "completed",
    "full",
    "whole",
    "entire",
    "total",
    "successive",
    "consecutive",
    "small",
    "pendulum",
    "fold",
    "fach",
    "fache",
    "fachen",
    "times",
    "x",
    "ganze",
    "ganzen",
    "volle",
    "vollen",
    "vollständige",
    "vollständigen",
    "komplette",
    "kompletten",
    "complètes",
    "completas",
    "completi",
    "kleine",
    "kleinen",
    "completos",
    "complets",
    "volledige",
    "hele",
    "hela",
    "pełnych",
];
/// Words for a number that is stated in another column or not at all.
const SEVERAL: [&str; 10] =
    ["n", "several", "many", "multiple", "mehrere", "mehrerer", "plusieurs", "diverse", "varie", "varias"];
/// Words before the duration that was timed.
const FOR: [&str; 10] = ["for", "für", "pour", "per", "para", "over", "über", "during", "voor", "för"];
/// Words between a result and its origin.
const FROM: [&str; 6] = ["from", "aus", "by", "based", "depuis", "da"];
/// Words after the number of another quantity: `T at 20 cm`.
const OTHER_UNITS: [&str; 13] =
    ["deg", "degree", "degrees", "grad", "rad", "m", "cm", "mm", "in", "g", "kg", "fps", "hz"];
/// Words for a mean: the mean of several periods is one period.
const MEAN: [&str; 20] = [
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
    "gemiddelde",
    "medelvärde",
    "medel",
    "média",
    "médio",
    "średnia",
    "średni",
    "moyen",
];

/// Number of periods that a column with this heading counts in each time, where the heading names a run, in itself or in a line above.
///
/// The words after the unit are a run only if they count no periods: `Time (s) for 10 oscillations` counts, `Time (s) Run 12` does not.
pub fn counted_in(heading: &str, run: &str) -> CountedPeriods {
    let without_run = heading.strip_suffix(run).unwrap_or(heading);
    match counted(without_run) {
        CountedPeriods::Said(1.0) | CountedPeriods::Nothing if counts_periods(run) => {
            counted(&format!("{} {run}", without_run.trim_end()))
        }
        of_both => of_both,
    }
}

/// Returns `true` if the supposed name of a run refers to periods, or begins with a number.
fn counts_periods(run: &str) -> bool {
    let words = words(run);
    let begins = |word: &String| {
        number(word).is_some() || [&FOR[..], &SEVERAL, &MEAN, &["x"]].iter().any(|list| is(list, word))
    };
    words.first().is_some_and(begins) || words.iter().any(|word| is(&PERIOD, word) || is(&HALF_PERIOD, word))
}

/// Number of periods that a column with this heading counts in each time.
pub fn counted(heading: &str) -> CountedPeriods {
    let words = words(heading);
    let unclear = || CountedPeriods::Unclear(heading.trim().to_owned());
    let count = |(index, word): (usize, &String)| Some(number(word)? * length_of(&words[index + 1..])?);
    let is_of_number = |index: usize| {
        words[index] == "per" && words.get(index + 1).is_some_and(|next| number(next).is_some())
    };
    let is_mean = (0..words.len()).any(|index| is(&MEAN, &words[index]) && !is_of_number(index));
    // `T = t/10` is one period.
    let quotient = heading.split_once('=').map(|(of, is)| (of.trim(), self::words(is)));
    if let Some(("T", is)) = &quotient
        && let [_, stroke, by, ..] = &is[..]
        && stroke == "/"
        && number(by).is_some()
    {
        return CountedPeriods::Said(1.0);
    }
    let is_divided = words.windows(2).any(|pair| pair[0] == "/" && number(&pair[1]).is_some());
    // A period may be what follows from the swings, or their time.
    let is_of_symbol =
        heading.trim_start().starts_with('T') || words.first().is_some_and(|word| word.starts_with("period"));
    let is_derived =
        is_of_symbol && words.windows(2).any(|pair| is(&FROM, &pair[0]) && number(&pair[1]).is_some());
    let may_be_count = (0..words.len()).any(|index| may_count(&words, index));
    let count = words.iter().enumerate().find_map(count);
    let is_part = count.is_some_and(|count| count < 1.0);
    if is_derived {
        return unclear();
    }
    match count.filter(|_| !is_part) {
        Some(count) if count.total_cmp(&1.0).is_eq() || !is_mean && !is_divided => {
            return CountedPeriods::Said(count);
        }
        Some(_) => return unclear(),
        None => {}
    }
    let is_several =
        (0..words.len()).any(|index| is(&SEVERAL, &words[index]) && length_of(&words[index + 1..]).is_some());
    let lasts_half = |index: usize| length_of(&words[index..]).is_some_and(|length| length < 1.0);
    let is_halved = words.windows(3).any(|three| three[0] == "t" && three[1] == "/" && three[2] == "2");
    if is_part || is_halved || (0..words.len()).any(lasts_half) {
        return if may_be_count || is_several {
            unclear()
        } else {
            CountedPeriods::Said(count.unwrap_or(0.5))
        };
    }
    if is_divided || is_several || may_be_count || words.iter().any(|word| is(&HALF, word)) {
        return unclear();
    }
    // A small t is any time.
    let is_period = |word: &String| match word.as_str() {
        "t" => heading.split(|letter: char| !letter.is_alphabetic()).any(|written| written == "T"),
        word => is(&PERIOD, word) && !is(&SWING, word),
    };
    match words.iter().any(is_period) {
        true => CountedPeriods::Said(1.0),
        false => CountedPeriods::Nothing,
    }
}

/// The certainty with which the numbers under a heading without a unit are numbers of swings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SwingNumbers {
    /// Words that state it: `swings`, `number of periods`, `Anzahl der Schwingungen`.
    Said,
    /// A word that may state it: `n`, `Anzahl`, `periods`.
    Possible,
    /// Other words.
    Other,
}

/// Returns `true` if a number may be one of swings: a positive multiple of one half.
#[must_use]
pub fn is_number_of_swings(number: f64) -> bool {
    number > 0.0 && number.is_finite() && (2.0 * number).fract() == 0.0
}

/// Words for a number, and words between it and the counted things.
const NUMBER: [&str; 26] = [
    "n",
    "no",
    "nr",
    "nb",
    "num",
    "number",
    "numbers",
    "anzahl",
    "zahl",
    "nombre",
    "numero",
    "número",
    "count",
    "counts",
    "counted",
    "many",
    "cantidad",
    "numer",
    "liczba",
    "ilość",
    "antal",
    "aantal",
    "номер",
    "число",
    "počet",
    "αριθμός",
];
const OF: [&str; 24] = [
    "of", "the", "de", "d", "des", "der", "den", "di", "del", "degli", "delle", "las", "les", "how", "deg",
    "º", "timed", "measured", "made", "da", "do", "das", "av", "van",
];
/// Numbers of swings as one word.
const SWING_NUMBER: [&str; 5] =
    ["schwingungszahl", "schwingungszahlen", "schwingungsanzahl", "periodenzahl", "periodenanzahl"];

/// The classification of a heading without a unit as one of numbers of swings.
pub(super) fn swing_numbers(heading: &str) -> SwingNumbers {
    let words = words(heading);
    let is_number = |word: &str| is(&NUMBER, word);
    let is_swings =
        |word: &str| word != "t" && !word.contains("dauer") && !word.contains("tijd") && is(&PERIOD, word);
    let is_known = |word: &String| is_number(word) || is_swings(word) || is(&OF, word) || is(&BETWEEN, word);
    let has = |of: &dyn Fn(&str) -> bool| words.iter().any(|word| of(word));
    let is_plural = |word: &str| {
        is_swings(word)
            && word.ends_with(['s', 'n', 'i', 'ć', 'ń', 'r'])
            && !["oscillation", "vibration"].contains(&word)
    };
    let is_period = |word: &str| ["period", "période", "período"].iter().any(|stem| word.starts_with(stem));
    match () {
        () if words.iter().any(|word| is(&SWING_NUMBER, word)) => SwingNumbers::Said,
        () if words.is_empty() || !words.iter().all(is_known) => SwingNumbers::Other,
        () if has(&is_number) && has(&is_swings) => SwingNumbers::Said,
        () if has(&is_plural) && !has(&is_period) => SwingNumbers::Said,
        () if has(&is_plural) || has(&is_number) => SwingNumbers::Possible,
        () => SwingNumbers::Other,
    }
}

/// Returns `true` if a heading says that its numbers are those of swings: `number of swings`, `Schwingung Nr.`.
#[must_use]
pub fn says_number_of_swings(heading: &str) -> bool {
    swing_numbers(heading) == SwingNumbers::Said
}

/// Returns `true` if a heading says that its numbers are those of half swings: `half swings`, `Halbschwingungen`, `number of half-periods`. A `half period`
/// is a time.
#[must_use]
pub fn says_number_of_half_swings(heading: &str) -> bool {
    let words = words(heading);
    let is_number = |word: &String| is(&NUMBER, word) || is(&OF, word);
    let counted: Vec<String> = words.iter().filter(|word| !is_number(word)).cloned().collect();
    let is_known = |word: &String| {
        word != "t" && [&HALF[..], &HALF_PERIOD, &PERIOD, &BETWEEN].iter().any(|list| is(list, word))
    };
    let is_time = |word: &String| {
        let ends = ["period", "periode", "période", "periodo", "período", "dauer", "tijd", "tid"];
        ends.iter().any(|end| word.ends_with(end))
    };
    let has_number = counted.len() < words.len();
    counted.iter().all(is_known)
        && length_of(&counted).is_some_and(|length| length < 1.0)
        && (has_number || !counted.last().is_some_and(is_time))
}

/// The length in periods of the unit with which these words begin: of a period, or of half of one.
fn length_of(words: &[String]) -> Option<f64> {
    let (first, rest) = words.split_first()?;
    match first.as_str() {
        word if is(&PERIOD, word) => Some(1.0),
        word if is(&HALF_PERIOD, word) => Some(0.5),
        word if is(&HALF, word) => length_of(rest).map(|length| 0.5 * length),
        word if is(&BETWEEN, word) => length_of(rest),
        _ => None,
    }
}

/// Returns `true` if a word may be a number of periods: one from ten on, since smaller ones after a symbol number the trials; or one after which a
/// timed quantity follows, or the first word; not the number of another quantity.
fn may_count(words: &[String], index: usize) -> bool {
    let next = words.get(index + 1);
    let is_of_other = next.is_some_and(|next| is(&OTHER_UNITS, next));
    let is_counted = length_of(&words[index + 1..]).is_some();
    let is_ordinal = |next: &str| ["st", "nd", "rd", "th"].contains(&next) || words[index].ends_with('.');
    let is_named = |next: &String| next != "/" && !is_ordinal(next) && !is(&UNITS_OF_TIME, next);
    let is_first = || index == 0 && next.is_some_and(is_named);
    let is_timed = || index > 0 && is(&FOR, &words[index - 1]);
    let may = |number: f64| number >= 10.0 || is_timed() || is_first();
    number(&words[index]).is_some_and(|number| !is_of_other && !is_counted && may(number))
}

/// Returns `true` if a heading speaks of a mean.
pub(super) fn is_mean(heading: &str) -> bool {
    words(heading).iter().any(|word| word != "per" && MEAN.contains(&word.as_str()))
}
