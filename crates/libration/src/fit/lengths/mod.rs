//! Periods against lengths of which only the differences are certain: g and the offset of the lengths.
//!
//! T² = 4π²R(A)²(L + δ)/g is a straight line in L. An offset δ, as when the string was measured and not the distance to the
//! centre of the bob, moves the line and leaves its slope, and so g, as it is. A bob that is not small bends it: κ/(L + δ) is
//! added, κ being 2r²/5 for a ball.
//!
//! Weights are *effective variances*, as for [periods against amplitudes](super::periods).

mod model;
mod table;

pub use model::{LengthFit, LengthModel};
pub use table::{LengthColumns, LengthTable};

use super::FitError;
use crate::quantity::Quantity;

/// A term counts as needed when chance would make it as large less often than this.
const NEEDED: f64 = 0.01;

/// What a table of periods against lengths says.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthsFit {
    /// The laws that the rows can determine, simpler ones first.
    pub fits: Vec<LengthFit>,
    /// κ = 2r²/5 of the bob, in m², where it was given and so is part of every law.
    pub known_gyration: Option<f64>,
    /// What a reader should know.
    pub warnings: Vec<String>,
}

impl LengthsFit {
    /// The law with an offset, or without one where the rows do not determine it: what the lengths are worth.
    #[must_use]
    pub fn best(&self) -> &LengthFit {
        self.of(LengthModel::Offset).unwrap_or(&self.fits[0])
    }

    /// The fit of a law, where the rows determine it.
    #[must_use]
    pub fn of(&self, model: LengthModel) -> Option<&LengthFit> {
        self.fits.iter().find(|fit| fit.model == model)
    }
}

/// g and the offset of the lengths; with the radius of the bob, a ball, its moment of inertia is taken into account.
///
/// # Errors
/// Fewer than two rows (without uncertainties three), all lengths the same, a radius that is not a positive number.
pub fn lengths(table: &LengthTable, bob_radius: Option<f64>) -> Result<LengthsFit, FitError> {
    if let Some(value) = bob_radius.filter(|radius| !(*radius > 0.0 && radius.is_finite())) {
        return Err(FitError::Length { value, uncertainty: 0.0 });
    }
    let known = bob_radius.map(|radius| 0.4 * radius * radius);
    let fit = |model| model::fit(table, model, known.unwrap_or(0.0));
    let free = LengthModel::ALL.into_iter();
    // A κ that is known is not free.
    let free = free.filter(|model| known.is_none() || *model != LengthModel::OffsetAndGyration);
    let fits: Vec<LengthFit> = free.filter_map(fit).collect();
    let needed = if table.is_weighted() { 2 } else { 3 };
    if fits.is_empty() || table.len() < needed {
        return Err(FitError::TooFewRows { found: table.len(), needed, parameters: "g" });
    }
    if fits.len() == 1 {
        return Err(FitError::EqualLengths);
    }
    let warnings = warnings(&fits, known, table);
    Ok(LengthsFit { fits, known_gyration: known, warnings })
}

fn warnings(fits: &[LengthFit], known: Option<f64>, table: &LengthTable) -> Vec<String> {
    let of = |model: LengthModel| fits.iter().find(|fit| fit.model == model);
    let mut warnings = vec![];
    let by_chance = |fit: Option<&LengthFit>| fit.and_then(|fit| fit.chance).unwrap_or(1.0);
    if by_chance(of(LengthModel::Offset)) < NEEDED {
        warnings.push(
            "the lengths are off by a constant: an offset is needed, and g without it is wrong".to_owned(),
        );
    }
    if by_chance(of(LengthModel::OffsetAndGyration)) < NEEDED {
        let gyration = of(LengthModel::OffsetAndGyration).and_then(|fit| fit.gyration);
        let gyration = gyration.map_or(0.0, |found| found.value);
        warnings.push(match gyration > 0.0 {
            true => format!(
                "T^2 against L is not straight: as with a ball of radius {:.1} mm; give the radius of the bob",
                1e3 * (2.5 * gyration).sqrt()
            ),
            false => "T^2 against L is not straight, and bends the other way than a large bob would bend it: look at \
                      the amplitudes and at how the lengths were measured"
                .to_owned(),
        });
    }
    let per_dof = of(LengthModel::Offset).and_then(LengthFit::chi2_per_dof);
    if per_dof.is_some_and(|per_dof| per_dof < 0.3) && table.len() > 5 {
        warnings.push(
            "the rows scatter much less than their uncertainties: these are perhaps common to all rows, and then belong \
             to the offset"
                .to_owned(),
        );
    }
    if per_dof.is_some_and(|per_dof| per_dof > 3.0) {
        warnings.push("the rows scatter more than their uncertainties say".to_owned());
    }
    let offset =
        of(LengthModel::Offset).and_then(|fit| fit.offset).map_or(0.0, |offset: Quantity| offset.value);
    if known.is_some_and(|known| offset.abs() > 10.0 * (2.5 * known).sqrt()) {
        warnings.push("the offset is much larger than the bob: check the unit of the lengths".to_owned());
    }
    warnings
}
