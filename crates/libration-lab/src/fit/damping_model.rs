//! Kinds of damping in a model.

use libration::internals::InOrder;
use std::fmt;
use std::str::FromStr;

use libration::decay::DampingKind;

/// Kinds of damping in a model: any of the three, or none.
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

/// Reasons why a text is not a damping model.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DampingModelError {
    /// A name that is not a kind of damping.
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

    /// All eight models, simpler ones first.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let mut all: Vec<Self> =
            (0..8).map(|bits| Self([bits & 2 != 0, bits & 1 != 0, bits & 4 != 0])).collect();
        all.put_in_order_by(|terms| terms.count());
        all
    }

    /// Returns the model with one kind.
    #[must_use]
    pub fn only(term: DampingKind) -> Self {
        Self(DampingKind::ALL.map(|other| other == term))
    }

    /// Returns `true` if the model has this kind.
    #[must_use]
    pub fn has(self, term: DampingKind) -> bool {
        self.iter().any(|other| other == term)
    }

    /// The kinds in the model.
    pub fn iter(self) -> impl Iterator<Item = DampingKind> + Clone {
        DampingKind::ALL.into_iter().zip(self.0).filter(|(_, there)| *there).map(|(term, _)| term)
    }

    /// Number of kinds in the model.
    #[must_use]
    pub fn count(self) -> usize {
        self.iter().count()
    }

    /// Returns `true` if all kinds of this model are in the other one too.
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
    libration::quantity::alternatives(&names)
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
            let position = DampingKind::ALL.iter().position(|term| term.name().eq_ignore_ascii_case(name));
            let index =
                position.ok_or_else(|| DampingModelError::Unknown(libration::quantity::excerpt(name)))?;
            if terms.0[index] {
                return Err(DampingModelError::Repeated(DampingKind::ALL[index]));
            }
            terms.0[index] = true;
        }
        Ok(terms)
    }
}
