//! A header cell → the quantity, the unit and the run that its words name.

mod companion;
mod stated;
mod unit;
pub(crate) mod words;

pub(super) use companion::{name_minima, name_uncertainties};
use libration::quantity::printable;
pub use stated::StatedUncertainty;
pub(super) use stated::without_stated;
pub(super) use unit::Measures;
pub use unit::{Unit, UnknownUnit};
use words::Words;
pub(super) use words::named;

/// Quantity of the numbers of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum QuantityKind {
    /// Time.
    Time,
    /// The angle of the pendulum.
    Angle,
    /// Angular velocity.
    AngularVelocity,
    /// A horizontal position.
    X,
    /// A vertical position.
    Y,
    /// An acceleration, as an accelerometer measures it.
    Acceleration,
    /// The state of a photogate: blocked or not.
    Gate,
    /// The run to which a row belongs.
    Run,
    /// Another quantity, or an unknown one.
    Other,
}

/// Heading of a column, as the header gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// The header cell as written; empty if there is none.
    pub text: String,
    /// The name without unit and run.
    pub name: String,
    /// Quantity of the numbers by the name and the unit.
    pub quantity: QuantityKind,
    /// `true` if the numbers are the uncertainties of the quantity.
    pub is_uncertainty: bool,
    /// The name of the column to which these uncertainties belong, if this name contains it, as `dT` contains `T`.
    pub uncertainty_of: Option<String>,
    /// The unit, where one is named and known.
    pub unit: Option<Unit>,
    /// The unit as written, known or not.
    pub unit_text: Option<String>,
    /// The run, as in `Run #3` or `Latest`.
    pub run: Option<String>,
    /// The number after the symbol, as in `t_{1}` or `theta2`.
    pub index: Option<String>,
    /// The uncertainty of all values, as in `T (s) ± 0.004`.
    pub stated_uncertainty: Option<StatedUncertainty>,
}

impl Heading {
    /// Reads a heading from these words; `unit` is from a line of units below, `group` from a line of titles above.
    #[doc(hidden)]
    pub fn read(text: &str, unit: Option<&str>, group: Option<&str>) -> Self {
        let text = printable(text);
        let text = text.trim();
        let (rest, run) = split_run(text);
        let (rest, is_uncertainty) = without_sign_of_uncertainty(rest);
        let (rest, stated_uncertainty) = without_stated(&rest);
        let (name, in_name, after) = split_unit(&rest);
        let unit_text = unit.map(bare).filter(|unit| !unit.is_empty()).or(in_name);
        let run = run.or(after).or(group).map(str::trim).filter(|run| !run.is_empty());
        let unit = unit_text.and_then(|unit| unit.parse().ok());
        let words = Words::read(name);
        let is_angular = unit == Some(Unit::Hertz)
            && unit_text.is_some_and(|unit_text| unit_text.contains('s'))
            && is_angular(name);
        let unit = if is_angular { Some(Unit::RadianPerSecond) } else { unit };
        Self {
            text: text.into(),
            name: name.into(),
            quantity: quantity(words.quantity, unit, unit_text),
            is_uncertainty: is_uncertainty || words.is_uncertainty,
            uncertainty_of: None,
            unit,
            unit_text: unit_text.map(Into::into),
            run: run.map(Into::into),
            index: words.index,
            stated_uncertainty,
        }
    }

    /// The text of a heading below a title, with the unit of the title: `Period Trial 1 (s)` for `Trial 1` below `Period (s)`.
    pub(super) fn under_title(text: &str, title: &str) -> String {
        match split_unit(title) {
            (name, Some(unit), _) if Self::read(text, None, None).unit.is_none() => {
                format!("{name} {text} ({unit})").trim().into()
            }
            (name, _, _) => format!("{name} {text}").trim().into(),
        }
    }

    /// Returns `true` for the uncertainty, or another reading, of the quantity in the column before: `T1`, `T2`.
    pub(super) fn goes_with(&self, before: &Self) -> bool {
        let stem = |heading: &Self| {
            let text = heading.text.to_lowercase();
            text.trim_end_matches(|c: char| !c.is_alphabetic()).to_owned()
        };
        self.is_uncertainty || stem(self) == stem(before)
    }

    /// Sets the unit found in the cells.
    pub(super) fn set_unit(&mut self, unit: Unit) {
        self.quantity = quantity(self.quantity, Some(unit), None);
        self.unit = Some(unit);
        self.unit_text = Some(unit.to_string());
    }

    /// Returns `true` if the numbers are this quantity itself.
    #[doc(hidden)]
    pub fn is(&self, quantity: QuantityKind) -> bool {
        self.quantity == quantity && !self.is_uncertainty
    }

    /// Returns `true` if the heading speaks of an uncertainty without naming its quantity: `±`, `error (deg)`.
    #[doc(hidden)]
    pub fn is_bare_uncertainty(&self) -> bool {
        self.is_uncertainty && words::without_uncertainty(&self.name).0.is_empty()
    }

    /// Returns `true` if both name the same quantity, uncertainty or not.
    pub(super) fn is_of_the_same(&self, other: &Self) -> bool {
        let plain = |heading: &Self| {
            let name = heading.uncertainty_of.as_ref().unwrap_or(&heading.name);
            words::without_uncertainty(name).0
        };
        !plain(self).is_empty() && plain(self) == plain(other)
    }

    /// Returns `true` if the heading bears this name, with or without the unit.
    pub(super) fn is_named(&self, asked: &str) -> bool {
        let plain = |text: &str| text.trim().to_lowercase();
        let asked = plain(asked);
        !asked.is_empty() && (plain(&self.text) == asked || plain(&self.name) == asked)
    }
}

/// A unit without the brackets or the stroke around it.
pub(super) fn bare(unit: &str) -> &str {
    let unit = unit.trim();
    unit.strip_prefix("in ")
        .unwrap_or(unit)
        .trim_start_matches(['(', '[', '/', '{'])
        .trim_end_matches([')', ']', '}'])
        .trim()
}

/// Marks of an uncertainty before the brackets around a quantity.
const SIGNS: [&str; 10] = ["u(", "σ(", "δ(", "∆(", "sigma(", "delta(", "sd(", "err(", "error(", "unc("];

/// `u(θ)`, `σ(θ)`, `Δ(θ)` → θ; `+/-` → ±. A capital U of an unknown quantity is a voltage.
fn without_sign_of_uncertainty(text: &str) -> (String, bool) {
    let text = text.replace("+/-", "±").replace("+-", "±");
    let lower = text.to_lowercase();
    let is_signed = SIGNS.iter().any(|sign| lower.starts_with(sign));
    let parts = text.split_once('(').and_then(|(_, rest)| rest.split_once(')')).filter(|_| is_signed);
    match parts {
        Some((of, after)) if !text.starts_with('U') || Words::read(of).quantity != QuantityKind::Other => {
            (format!("{of}{after}"), true)
        }
        _ => (text, false),
    }
}

/// `Latest: Time (s)`, `Data Set 1:Time(s)`, `Time (s) Run #3` → the remaining text, and the run.
fn split_run(text: &str) -> (&str, Option<&str>) {
    if let Some((run, rest)) =
        text.split_once(':').filter(|(run, rest)| is_run(run) && !rest.trim().is_empty())
    {
        return (rest.trim(), Some(run.trim()));
    }
    let suffix = ["run #", "run", "#"].iter().find_map(|word| {
        let at = text.to_lowercase().rfind(word).filter(|&at| at > 0 && text.is_char_boundary(at))?;
        let number = text.get(at + word.len()..)?.trim();
        (!number.is_empty() && number.bytes().all(|digit| digit.is_ascii_digit())).then_some(at)
    });
    match suffix {
        Some(at) => (text[..at].trim(), Some(text[at..].trim())),
        None => (text, None),
    }
}

fn is_run(text: &str) -> bool {
    let word = text.trim().to_lowercase();
    let words = [
        "latest", "run", "data set", "dataset", "trial", "set", "messung", "versuch", "essai", "mesure",
        "prova",
    ];
    words.iter().any(|run| word.starts_with(run))
}

/// `Time (s) morning`, `t [ms]`, `Angle/rad`, `t / s`, `time_us` → the name, the unit, and the text after the unit.
fn split_unit(text: &str) -> (&str, Option<&str>, Option<&str>) {
    let text = text.trim_end_matches([':', ' ']);
    for (open, close) in [('(', ')'), ('[', ']'), ('{', '}'), ('<', '>')] {
        // `T_{m}` is a mean.
        let is_of_unit = |(name, rest): &(&str, &str)| {
            let is_subscript = name.is_empty() || name.ends_with(['_', '^']);
            "([".contains(open) || !is_subscript && rest.strip_suffix(close).is_some_and(is_unit)
        };
        if let Some((name, rest)) = text.split_once(open).filter(is_of_unit) {
            if let Some(after) = after_number(rest, close) {
                let name = text[..text.len() - after.len()].trim();
                let unit = Some(bare(after)).filter(|unit| unit.parse::<Unit>().is_ok());
                return (if unit.is_some() { name } else { text }, unit, None);
            }
            let (unit, after) = rest.rsplit_once(close).unwrap_or((rest, ""));
            let after = Some(after.trim()).filter(|after| !after.is_empty());
            return (name.trim().trim_end_matches('/').trim(), Some(unit.trim()), after);
        }
    }
    let with_unit =
        |between: &str| text.rsplit_once(between).filter(|(_, unit)| unit.parse::<Unit>().is_ok());
    let in_words = with_unit(" in ").map(|(name, unit)| (name, unit.trim()));
    let at_stroke = || split_at_stroke(text).map(|(name, unit)| (name, bare(unit)));
    let at_end = || with_unit("_").or_else(|| with_unit(" ")).map(|(name, unit)| (name, unit.trim()));
    if let Some((name, unit)) = in_words.or_else(at_stroke).or_else(at_end) {
        return (name.trim(), Some(unit), None);
    }
    // A unit of angles or rotations is all of a name: `rad`, `deg`, `rpm`.
    let is_name =
        |unit: Unit| matches!(unit, Unit::Radian | Unit::Milliradian | Unit::Degree | Unit::PerMinute);
    if text.parse().is_ok_and(is_name) { ("", Some(text), None) } else { (text, None, None) }
}

fn is_unit(text: &str) -> bool {
    text.parse::<Unit>().is_ok()
}

/// Returns `true` if a frequency in 1/s is an angular one by its name: `ω`, `Kreisfrequenz`.
fn is_angular(name: &str) -> bool {
    const WORDS: [&str; 7] = ["angul", "ángul", "kreisfreq", "winkelgeschw", "pulsation", "pulsaz", "omega"];
    let lower = name.to_lowercase();
    lower.starts_with('ω') || WORDS.iter().any(|word| lower.contains(word))
}

/// The text after the number of a reading in brackets: ` [s]` of `T (2) [s]`.
fn after_number(rest: &str, close: char) -> Option<&str> {
    let (number, after) = rest.split_once(close)?;
    (!number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())).then_some(after)
}

/// Splits `t / s` but not `T/2`, whose 2 is not a unit; `T/2 / s` has the unit s.
fn split_at_stroke(text: &str) -> Option<(&str, &str)> {
    let (name, rest) = text.split_once('/').filter(|(name, _)| !name.trim().is_empty())?;
    match rest.trim_start().starts_with(|letter: char| letter.is_ascii_digit()) {
        true => text.rsplit_once('/').filter(|(before, _)| before.len() > name.len()),
        false => Some((name, rest)),
    }
}

/// Quantity from a name and its unit; unknown if the unit contradicts the name.
fn quantity(named: QuantityKind, unit: Option<Unit>, unit_text: Option<&str>) -> QuantityKind {
    match (unit.map(Unit::measures), named) {
        (Some(Measures::Time), QuantityKind::Time) => QuantityKind::Time,
        (Some(Measures::Angle), QuantityKind::Angle | QuantityKind::Other) => QuantityKind::Angle,
        (Some(Measures::AngularVelocity), QuantityKind::Gate | QuantityKind::Run | QuantityKind::Time) => {
            QuantityKind::Other
        }
        (Some(Measures::AngularVelocity), _) => QuantityKind::AngularVelocity,
        (Some(Measures::Length), QuantityKind::X | QuantityKind::Y) => named,
        (None, QuantityKind::Acceleration) => QuantityKind::Acceleration,
        (None, named) if unit_text.is_none() => named,
        (None, _) if unit_text.is_some_and(words::is_of_acceleration) => QuantityKind::Acceleration,
        // Of a unit that is not known here it is asked later.
        (
            None,
            QuantityKind::Angle | QuantityKind::AngularVelocity | QuantityKind::Gate | QuantityKind::Run,
        ) => named,
        _ => QuantityKind::Other,
    }
}
