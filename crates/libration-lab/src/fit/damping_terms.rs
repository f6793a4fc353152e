//! Which kinds of damping a model has.

use std::fmt;
use std::str::FromStr;

/// A kind of damping.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DampingTerm {
    /// Dry friction: d·sign θ′, with d in rad/s².
    Dry,
    /// Drag by a viscous fluid: b·θ′, with b in 1/s.
    Linear,
    /// Drag by a turbulent fluid: c·θ′·|θ′|, with c without a unit.
    Quadratic,
}

impl DampingTerm {
    /// All, in the order of the power of the velocity.
    pub const ALL: [Self; 3] = [Self::Dry, Self::Linear, Self::Quadratic];

    /// `dry`, `linear`, `quadratic`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Dry => "dry",
            Self::Linear => "linear",
            Self::Quadratic => "quadratic",
        }
    }

    /// Of the velocity, as [`decay`](libration::decay) counts them.
    #[must_use]
    pub fn exponent(self) -> f64 {
        match self {
            Self::Dry => 0.0,
            Self::Linear => 1.0,
            Self::Quadratic => 2.0,
        }
    }

    /// Of its coefficient; `1` where there is none.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Dry => "rad/s^2",
            Self::Linear => "1/s",
            Self::Quadratic => "1",
        }
    }
}

/// Which kinds of damping a model has: any of the three, or none.
///
/// # Examples
/// ```
/// use libration_lab::fit::DampingTerms;
/// let terms: DampingTerms = "linear+dry".parse()?;
/// assert_eq!(terms.to_string(), "dry+linear");
/// assert!("viscous".parse::<DampingTerms>().is_err());
/// # Ok::<(), libration_lab::fit::DampingTermsError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DampingTerms([bool; 3]);

/// A name of no kind of damping.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a damping model: give undamped, dry, linear, quadratic, or a sum such as dry+linear")]
pub struct DampingTermsError(String);

impl DampingTerms {
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
    pub fn only(term: DampingTerm) -> Self {
        Self(DampingTerm::ALL.map(|other| other == term))
    }

    /// Whether this kind is there.
    #[must_use]
    pub fn has(self, term: DampingTerm) -> bool {
        self.iter().any(|other| other == term)
    }

    /// The kinds that are there.
    pub fn iter(self) -> impl Iterator<Item = DampingTerm> + Clone {
        DampingTerm::ALL.into_iter().zip(self.0).filter(|(_, there)| *there).map(|(term, _)| term)
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

impl FromIterator<DampingTerm> for DampingTerms {
    fn from_iter<I: IntoIterator<Item = DampingTerm>>(terms: I) -> Self {
        let terms: Vec<DampingTerm> = terms.into_iter().collect();
        Self(DampingTerm::ALL.map(|term| terms.contains(&term)))
    }
}

/// `dry`, `dry or linear`, `dry, linear or quadratic`.
#[must_use]
pub fn alternatives(models: &[DampingTerms]) -> String {
    let names: Vec<String> = models.iter().map(ToString::to_string).collect();
    match &names[..] {
        [all @ .., before, last] if !all.is_empty() => format!("{}, {before} or {last}", all.join(", ")),
        [before, last] => format!("{before} or {last}"),
        names => names.join(", "),
    }
}

impl fmt::Display for DampingTerms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.iter().map(DampingTerm::name).collect();
        f.pad(&if names.is_empty() { "undamped".to_owned() } else { names.join("+") })
    }
}

impl FromStr for DampingTerms {
    type Err = DampingTermsError;
    fn from_str(text: &str) -> Result<Self, DampingTermsError> {
        if text.trim().eq_ignore_ascii_case("undamped") {
            return Ok(Self::UNDAMPED);
        }
        let mut terms = Self::UNDAMPED;
        for name in text.split('+').map(str::trim) {
            let place = DampingTerm::ALL.iter().position(|term| term.name().eq_ignore_ascii_case(name));
            let place = place.ok_or_else(|| DampingTermsError(libration::quantity::excerpt(name)))?;
            terms.0[place] = true;
        }
        Ok(terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn models_are_listed_as_alternatives() {
        let all = DampingTerm::ALL.map(DampingTerms::only);
        assert_eq!(alternatives(&all), "dry, linear or quadratic");
        assert_eq!(alternatives(&all[..2]), "dry or linear");
        assert_eq!(alternatives(&all[..1]), "dry");
        assert_eq!(alternatives(&[]), "");
    }

    #[test]
    fn a_model_is_part_of_those_that_have_its_terms_and_others() {
        for a in DampingTerms::all() {
            for b in DampingTerms::all() {
                let part = DampingTerm::ALL.iter().all(|&term| !a.has(term) || b.has(term));
                assert_eq!(a.is_part_of(b), part, "{a} {b}");
            }
        }
        assert!(DampingTerms::UNDAMPED.is_part_of(DampingTerms::only(DampingTerm::Dry)));
        assert!(!DampingTerms::only(DampingTerm::Dry).is_part_of(DampingTerms::only(DampingTerm::Quadratic)));
    }
}
