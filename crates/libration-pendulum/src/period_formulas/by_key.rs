//! The known formulas, by key.

use std::sync::LazyLock;

use super::catalogue::{CLOSED, Entry};
use super::family::Family;
use super::formula::{Complexity, LeadingTerm, PeriodFormula};
use libration_numbers::catalogue::{self, UnknownKey};

static CATALOGUE: LazyLock<Vec<PeriodFormula>> = LazyLock::new(|| {
    let listed = [
        (Family::PowerSeries, 3),
        (Family::FourierPerturbation, 3),
        (Family::SineSquared, 4),
        (Family::PadePower, 2),
        (Family::PadeSineSquared, 2),
    ];
    let series = listed.into_iter().flat_map(|(family, most)| (1..=most).map(move |n| family.formula(n)));
    let (first, others) = CLOSED.split_at(1);
    first
        .iter()
        .map(PeriodFormula::from_entry)
        .chain(series)
        .chain(others.iter().map(PeriodFormula::from_entry))
        .collect()
});

/// Every formula of the catalogue, each once, the series with few terms; [`PeriodFormula::by_key`] gives more.
#[must_use]
pub fn catalogue() -> &'static [PeriodFormula] {
    &CATALOGUE
}

impl PeriodFormula {
    /// The formula of this key, or the one that is the same under another (`agm_a2` is `carvalhaes_suppes`,
    /// `power_series_1` is `bernoulli`, `black_vel_1` is `denman`). The series `power_series_N`, `black_vel_N` and `sin2_series_N` have any
    /// number N of corrections up to [`MOST_TERMS`](super::MOST_TERMS), the Padé approximants `pade_power_N` and `pade_sin2_N` any degree up to
    /// [`LARGEST_PADE`](super::LARGEST_PADE).
    ///
    /// # Errors
    /// No formula has this key; the error lists the nearest keys and all of them.
    pub fn by_key(key: &str) -> Result<Self, UnknownKey> {
        let listed = catalogue::by_key(catalogue().iter(), key).cloned();
        listed.or_else(|unknown| Family::from_key(key).ok_or(unknown))
    }

    fn from_entry(entry: &Entry) -> Self {
        let (functions, roots, operations) = entry.effort;
        Self {
            key: entry.key.to_owned(),
            also: entry.also.iter().map(|&key| key.to_owned()).collect(),
            name: entry.name.to_owned(),
            authors: entry.authors.to_owned(),
            year: entry.year,
            source: entry.source.to_owned(),
            attribution: entry.attribution,
            text: entry.text.to_owned(),
            derivation: entry.derivation.to_owned(),
            latex: entry.latex.to_owned(),
            domain: entry.domain.to_owned(),
            complexity: Complexity { functions, roots, operations },
            leading_error: entry.leading_error.and_then(LeadingTerm::from_text),
            law: entry.law.clone(),
        }
    }
}
