//! Periods against lengths of which only the differences are certain: g and the offset of the lengths.
//!
//! T² = 4π²R(A)²(L + δ)/g is a straight line in L. An offset δ, as when the string was measured and not the distance to the
//! centre of the bob, moves the line and leaves its slope, and so g, as it is. A bob that is not small bends it: κ/(L + δ) is
//! added, κ being 2r²/5 for a ball.
//!
//! Weights are *effective variances*, as for [periods against amplitudes](super::periods).

mod model;
mod table;
mod warning;

pub use model::{LengthFit, LengthModel};
pub use table::{LengthColumns, LengthTable};
pub use warning::LengthsWarning;

use super::budget::{self, BudgetInput, CombinedUncertainty, Contribution, Evaluation};
use super::{FitError, Uncertain};
use libration::quantity::Quantity;

/// Known quantities besides the table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LengthsOptions {
    /// Radius of the bob, a ball, in metres: its moment of inertia is then taken into account.
    pub bob_radius: Option<Quantity>,
    /// The relative standard uncertainty of the clock, which multiplies all periods.
    pub clock: Option<f64>,
    /// Standard uncertainties of the periods, in seconds, by what all readings share, such as an observer who stops late: all are off alike.
    pub shared_timing: Option<Vec<f64>>,
}

/// The results of a fit to a table of periods against lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthsFit {
    /// The laws that the rows can determine, simpler ones first.
    pub fits: Vec<LengthFit>,
    /// κ = 2r²/5 of the bob, in m², where it was given and so is part of every law.
    pub known_gyration: Option<f64>,
    /// The uncertainty of the best g, with the effects that all rows share: clock and bob.
    pub combined: CombinedUncertainty,
    /// Warnings about the fit.
    pub warnings: Vec<LengthsWarning>,
}

impl LengthsFit {
    /// The law with an offset, or without one where the rows do not determine it.
    #[must_use]
    pub fn best(&self) -> &LengthFit {
        self.law(LengthModel::Offset).unwrap_or(&self.fits[0])
    }

    /// The best g with all of its uncertainty, in m/s².
    #[must_use]
    pub fn gravity(&self) -> Uncertain {
        Uncertain { value: self.best().g.value, uncertainty: self.combined.standard }
    }

    /// The fit of a law, where the rows determine it.
    #[must_use]
    pub fn law(&self, model: LengthModel) -> Option<&LengthFit> {
        self.fits.iter().find(|fit| fit.model == model)
    }
}

/// Fits g and the offset of the lengths.
///
/// # Errors
/// Fails for fewer than two rows (without uncertainties three), equal lengths, a radius that is not a positive number, and an unusable
/// uncertainty.
pub fn lengths(table: &LengthTable, options: &LengthsOptions) -> Result<LengthsFit, FitError> {
    options.check()?;
    let radius = options.bob_radius.map(|radius| radius.value);
    let known = radius.map(model::gyration);
    let free = LengthModel::ALL.into_iter();
    // A κ that is known is not free.
    let free = free.filter(|model| known.is_none() || *model != LengthModel::OffsetAndGyration);
    let fits = free.map(|model| model::fit(table, model, radius)).collect::<Result<Vec<_>, _>>()?;
    let fits: Vec<LengthFit> = fits.into_iter().flatten().collect();
    let needed = if table.is_weighted() { 2 } else { 3 };
    if fits.is_empty() || table.len() < needed {
        return Err(FitError::TooFewRows { found: table.len(), needed, parameters: "g" });
    }
    if fits.len() == 1 {
        let differ = table.rows.windows(2).any(|pair| pair[0].length.total_cmp(&pair[1].length).is_ne());
        return Err(match radius.filter(|_| differ) {
            Some(radius) => FitError::BobRadius { radius },
            None if differ => FitError::PeriodsWithoutLength,
            None => FitError::EqualLengths,
        });
    }
    // The same fit as `best` returns.
    let best = fits.iter().find(|fit| fit.model == LengthModel::Offset).unwrap_or(&fits[0]);
    let combined = options.combined(table, best)?;
    let mut fit = LengthsFit { fits, known_gyration: known, combined, warnings: vec![] };
    fit.warnings = warning::warnings(&fit);
    Ok(fit)
}

impl LengthsOptions {
    fn check(&self) -> Result<(), FitError> {
        let usable = |spread: f64| (0.0..f64::INFINITY).contains(&spread);
        if let Some(Quantity { value, uncertainty }) = self.bob_radius {
            let uncertainty = uncertainty.unwrap_or(0.0);
            if !(value > 0.0 && value.is_finite() && usable(uncertainty)) {
                return Err(FitError::Length { value, uncertainty });
            }
        }
        self.clock.filter(|clock| !usable(*clock)).map_or(Ok(()), |clock| Err(FitError::Clock(clock)))
    }

    /// The uncertainty of g by the slope of the line, the bob and the clock.
    fn combined(&self, table: &LengthTable, best: &LengthFit) -> Result<CombinedUncertainty, FitError> {
        let g = best.g.value;
        let slope = Contribution {
            evaluation: Evaluation::Statistics,
            degrees_of_freedom: best.uncertainty_degrees_of_freedom(),
            ..Contribution::judged(BudgetInput::Slope, 1.0 / g, Some(best.g.uncertainty / (g * g)), -g * g)
        };
        let radius = self.bob_radius.map(|radius| {
            let refitted = |radius: f64| {
                let fit = model::fit(table, best.model, Some(radius)).ok().flatten();
                fit.map_or(f64::NAN, |fit| fit.g.value)
            };
            let sensitivity = budget::derivative(radius.value, radius.value, refitted);
            Contribution::judged(BudgetInput::BobRadius, radius.value, radius.uncertainty, sensitivity)
        });
        let clock =
            self.clock.map(|clock| Contribution::judged(BudgetInput::Clock, 1.0, Some(clock), -2.0 * g));
        let shared_timing = self.shared_timing.as_ref().map(|shifts| {
            let mean: f64 = shifts.iter().sum::<f64>() / table.rows.iter().map(|row| row.period).sum::<f64>();
            let refitted = |factor: f64| {
                let shifts = shifts.iter().map(|shift| (factor - 1.0) / mean * shift);
                let fit = model::fit(&table.shifted(shifts), best.model, self.bob_radius.map(|it| it.value));
                fit.ok().flatten().map_or(f64::NAN, |fit| fit.g.value)
            };
            let sensitivity = budget::derivative(1.0, 1.0, refitted);
            Contribution::judged(BudgetInput::SharedTiming, 1.0, Some(mean), sensitivity)
        });
        let contributions = [Some(slope), radius, clock, shared_timing].into_iter().flatten().collect();
        CombinedUncertainty::new(contributions, &[]).map_err(|_| FitError::NoConvergence("the bob"))
    }
}
