//! Which kinds of damping a model has.

use std::fmt;
use std::str::FromStr;

use libration::decay::DampingKind;

/// Which kinds of damping a model has: any of the three, or none.
///
/// # Examples
/// ```
/// use libration_lab::fit::DampingModel;
/// let terms: DampingModel = "linear+dry".parse()?;
/// assert_eq!(terms.to_string(), "dry+linear");
/// assert!("viscous".parse::<DampingModel>().is_err());
/// # Ok::<(), libration_lab::fit::DampingModelError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DampingModel([bool; 3]);

/// Why a text is not a damping model.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DampingModelError {
    /// A name of no kind of damping.
    #[error(
        "`{0}` is not a damping model: give undamped, dry, linear, quadratic, or a sum such as dry+linear"
    )]
    Unknown(String),
    /// A kind that the sum has twice.
    #[error("{} damping is in the sum twice: name each kind once, such as dry+linear", .0.name())]
    Repeated(DampingKind),
}

impl DampingModel {
    /// No damping at all.
    pub const UNDAMPED: Self = Self([false; 3]);

    /// All eight, simpler ones first.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let mut all: Vec<Self> =
            (0..8).map(|bits| Self([bits & 2 != 0, bits & 1 != 0, bits & 4 != 0])).collect();
        all.sort_by_key(|terms| terms.count());
        all
    }

    /// With one kind.
    #[must_use]
    pub fn only(term: DampingKind) -> Self {
        Self(DampingKind::ALL.map(|other| other == term))
    }

    /// Whether this kind is there.
    #[must_use]
    pub fn has(self, term: DampingKind) -> bool {
        self.iter().any(|other| other == term)
    }

    /// The kinds that are there.
    pub fn iter(self) -> impl Iterator<Item = DampingKind> + Clone {
        DampingKind::ALL.into_iter().zip(self.0).filter(|(_, there)| *there).map(|(term, _)| term)
    }

    /// How many there are.
    #[must_use]
    pub fn count(self) -> usize {
        self.iter().count()
    }

    /// Whether all kinds that are here are there too.
    #[must_use]
    pub fn is_part_of(self, other: Self) -> bool {
        self.iter().all(|term| other.has(term))
    }
}

impl FromIterator<DampingKind> for DampingModel {
    fn from_iter<I: IntoIterator<Item = DampingKind>>(terms: I) -> Self {
        let terms: Vec<DampingKind> = terms.into_iter().collect();
        Self(DampingKind::ALL.map(|term| terms.contains(&term)))
    }
}

/// `dry`, `dry or linear`, `dry, linear or quadratic`.
#[must_use]
pub fn alternatives(models: &[DampingModel]) -> String {
    let names: Vec<String> = models.iter().map(ToString::to_string).collect();
    match &names[..] {
        [all @ .., before, last] if !all.is_empty() => format!("{}, {before} or {last}", all.join(", ")),
        [before, last] => format!("{before} or {last}"),
        names => names.join(", "),
    }
}

impl fmt::Display for DampingModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(DampingKind::name).collect();
        f.pad(&if names.is_empty() { "undamped".to_owned() } else { names.join("+") })
    }
}

impl FromStr for DampingModel {
    type Err = DampingModelError;
    fn from_str(text: &str) -> Result<Self, DampingModelError> {
        if text.trim().eq_ignore_ascii_case("undamped") {
            return Ok(Self::UNDAMPED);
        }
        let mut terms = Self::UNDAMPED;
        for name in text.split('+').map(str::trim) {
            let place = DampingKind::ALL.iter().position(|term| term.name().eq_ignore_ascii_case(name));
            let place =
                place.ok_or_else(|| DampingModelError::Unknown(libration::quantity::excerpt(name)))?;
            if terms.0[place] {
                return Err(DampingModelError::Repeated(DampingKind::ALL[place]));
            }
            terms.0[place] = true;
        }
        Ok(terms)
    }
}
