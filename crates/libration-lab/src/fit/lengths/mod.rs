//! Periods against lengths of which only the differences are certain: g and the offset of the lengths.
//!
//! T² = 4π²R(A)²(L + δ)/g is a straight line in L. An offset δ, as when the string was measured and not the distance to the
//! centre of the bob, moves the line and leaves its slope, and so g, as it is. A bob that is not small bends it: κ/(L + δ) is
//! added, κ being 2r²/5 for a ball.
//!
//! A bar that is turned about several points has T²h = 4π²R²(k² + h²)/g at a distance h from its centre of mass: the period falls up to h = k. Two knife edges
//! give g by Bessel's formula.
//!
//! Weights are *effective variances*, as for [periods against amplitudes](super::periods).

mod bar;
mod corrected;
mod model;
mod outlying;
mod power_law;
mod reversible;
mod table;
mod variance_components;
mod warning;

pub use model::{LengthFit, LengthModel};
pub use power_law::PowerLaw;
pub use table::{LengthColumns, LengthTable};
pub use warning::LengthsWarning;

use super::budget::{
    self, BudgetInput, BudgetRow, CombinedUncertainty, Contribution, Corrections, Evaluation,
};
use super::cycles::SEPARATED;
use super::{FitError, Uncertain};
use corrected::CorrectedLaw;
use libration::quantity::Quantity;

/// The kind of pendulum in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LengthsPendulum {
    /// A bob on a string or light rod.
    Simple,
    /// A bar that is turned about several points.
    Bar,
    /// A bar with two knife edges, at distances from the centre of mass between them.
    Reversible,
}

/// Known quantities besides the table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LengthsOptions {
    /// All corrections of g; the moment of inertia of a bob is then part of every law.
    pub corrections: Corrections,
    /// The relative standard uncertainty of the clock, which multiplies all periods.
    pub clock: Option<f64>,
    /// Standard uncertainties of the periods, in seconds, by the common error of all readings, such as that of an observer who stops late.
    pub shared_timing: Option<Vec<f64>>,
    /// The pendulum; if `None`, a bar if the periods show it, otherwise a simple one.
    pub pendulum: Option<LengthsPendulum>,
    /// Distance of the knife edges of a reversible pendulum, in metres; the sum of their distances from the centre of mass if `None`.
    pub edges: Option<Quantity>,
}

/// The results of a fit to a table of periods against lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthsFit {
    /// The laws that the rows can determine, simpler ones first.
    pub fits: Vec<LengthFit>,
    /// The law that g is from.
    pub preferred: LengthModel,
    /// T = a·Lⁿ, where the lengths are those of a simple pendulum.
    pub power_law: Option<PowerLaw>,
    /// κ = 2r²/5 of the bob, in m², if it is given and thus part of every law.
    pub known_gyration: Option<f64>,
    /// The uncertainty of the best g, with the effects that all rows share: clock, bob and others.
    pub combined: CombinedUncertainty,
    /// `true` if the rounding of the periods is their uncertainty, as the rows scatter less.
    pub weighted_by_rounding: bool,
    /// The budget of g effect by effect: its correction and its part of the uncertainty.
    pub budget: Vec<BudgetRow>,
    /// Warnings about the fit.
    pub warnings: Vec<LengthsWarning>,
}

impl LengthsFit {
    /// The preferred law: for a simple pendulum with an offset, or without one if the rows do not determine it; for a bar with the given centre of
    /// mass, unless the rows need another.
    #[must_use]
    pub fn best(&self) -> &LengthFit {
        self.law(self.preferred).unwrap_or(&self.fits[0])
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
pub fn fit_lengths(table: &LengthTable, options: &LengthsOptions) -> Result<LengthsFit, FitError> {
    options.check()?;
    let fit = as_weighted(table, options)?;
    let scatter = fit.best().standard_deviations.first().copied().unwrap_or(f64::INFINITY);
    match table.weighted_by_rounding(scatter) {
        Some(table) => Ok(LengthsFit { weighted_by_rounding: true, ..as_weighted(&table, options)? }),
        None => Ok(fit),
    }
}

fn as_weighted(table: &LengthTable, options: &LengthsOptions) -> Result<LengthsFit, FitError> {
    if options.pendulum == Some(LengthsPendulum::Reversible) {
        return of_reversible(table, options);
    }
    let bars = bars(table, options);
    if let Some((row, length)) = table.negative().filter(|_| bars.is_empty()) {
        return Err(FitError::LengthOfRow { row, length });
    }
    if options.pendulum.is_none()
        && let Some((row, length)) = mistaken_sign(table, options, &bars)
    {
        return Err(FitError::SignOfLength { row, length, positive: length.abs() });
    }
    if options.pendulum == Some(LengthsPendulum::Bar) || table.negative().is_some() {
        return of_bars(table, options, &bars);
    }
    let fits = of_strings(table, options);
    match fits {
        Ok(fits) if !is_bar(&bars, table) || options.pendulum.is_some() => of_simple(table, options, fits),
        Ok(_) => of_bars(table, options, &bars),
        Err(FitError::PeriodsWithoutLength) if preferred_bar(&bars).is_some_and(is_determined) => {
            of_bars(table, options, &bars)
        }
        Err(error) => Err(error),
    }
}

/// The laws of a bob on a string: with an offset in any case.
fn of_strings(table: &LengthTable, options: &LengthsOptions) -> Result<Vec<LengthFit>, FitError> {
    let radius = options.bob_radius();
    let gyration = radius.map(model::gyration);
    let free = LengthModel::OF_STRINGS.into_iter();
    // A κ that is known is not free.
    let free = free.filter(|model| gyration.is_none() || *model != LengthModel::OffsetAndGyration);
    let fits = free.map(|model| model::fit(table, model, radius)).collect::<Result<Vec<_>, _>>()?;
    let fits: Vec<LengthFit> = fits.into_iter().flatten().collect();
    let needed = if table.is_weighted() { 2 } else { 3 };
    if fits.is_empty() || table.len() < needed {
        return Err(FitError::TooFewRows { rows: table.len(), needed, parameters: "g" });
    }
    if !fits.iter().any(|fit| fit.model == LengthModel::Offset) {
        let differ = table.rows.windows(2).any(|pair| pair[0].length.total_cmp(&pair[1].length).is_ne());
        return Err(match radius.filter(|_| differ) {
            Some(radius) => FitError::BobRadius { radius },
            None if differ => FitError::PeriodsWithoutLength,
            None => FitError::EqualLengths,
        });
    }
    Ok(fits)
}

fn of_simple(
    table: &LengthTable,
    options: &LengthsOptions,
    fits: Vec<LengthFit>,
) -> Result<LengthsFit, FitError> {
    let preferred = LengthModel::Offset;
    let corrected = options.corrected(table, preferred)?;
    let fits = if corrected == *table { fits } else { of_strings(&corrected, options)? };
    let known_gyration = options.corrections.bob.map(|bob| bob.gyration());
    let power_law = power_law::power_law(&corrected);
    let mut fit = options.with_budget(table, fits, preferred, None)?;
    (fit.power_law, fit.known_gyration) = (power_law, known_gyration);
    let radius = options.bob_radius();
    let offset = |table: &LengthTable| model::fit(table, preferred, radius).ok().flatten();
    fit.warnings = warning::warnings(
        &fit,
        &corrected,
        outlying::outlying(&corrected, &offset, Some(LengthModel::OffsetAndGyration)),
    );
    Ok(fit)
}

/// The laws of a bar that the rows determine; empty if a bob or string is given.
fn bars(table: &LengthTable, options: &LengthsOptions) -> Vec<LengthFit> {
    let Corrections { bob, rod_mass, stretch, .. } = options.corrections;
    let is_bare = bob.is_none() && rod_mass.is_none() && stretch.is_none();
    let is_possible = is_bare && options.pendulum != Some(LengthsPendulum::Simple);
    let laws = LengthModel::OF_BARS.into_iter().filter(|_| is_possible);
    let mut fits: Vec<LengthFit> = laws.filter_map(|model| bar::fit(table, model)).collect();
    if let [at_zero, free] = &mut fits[..] {
        free.p_value = bar::improvement_by_chance(at_zero, free);
    }
    fits
}

/// The law of a bar: with the centre of mass at zero, unless chance would make as large an improvement by another centre in fewer than one table in a
/// hundred.
fn preferred_bar(bars: &[LengthFit]) -> Option<&LengthFit> {
    let [at_zero, free] = LengthModel::OF_BARS.map(|model| bars.iter().find(|fit| fit.model == model));
    free.filter(|fit| at_zero.is_none() || fit.p_value.is_some_and(|chance| chance < CHANCE)).or(at_zero)
}

const CHANCE: f64 = 0.01;

/// The only negative length, by row from one, where the periods are not those of a bar that is turned about points on both sides: Akaike's criterion does not
/// separate that from a simple pendulum with the absolute value, or its radius of gyration is small.
fn mistaken_sign(table: &LengthTable, options: &LengthsOptions, bars: &[LengthFit]) -> Option<(usize, f64)> {
    /// Largest distance of points of a uniform bar in radii of gyration, with a margin: they are at most √3 from its centre. For a string with an
    /// offset δ of its lengths L the radius comes out as √(δL).
    const FARTHEST: f64 = 2.0;
    let negative =
        table.negative().filter(|_| table.rows.iter().filter(|row| row.length < 0.0).count() == 1)?;
    let positive = table.of_positive_lengths();
    of_strings(&positive, options).ok()?;
    let shortest = positive.rows.iter().map(|row| row.length).fold(f64::INFINITY, f64::min);
    let is_of_bar = |fit: &LengthFit| {
        let is_separated = fit.aicc.is_some_and(|aicc| aicc + SEPARATED < aicc_of_strings(&positive));
        is_separated && fit.gyration.is_some_and(|gyration| FARTHEST * gyration.value.sqrt() > shortest)
    };
    (!preferred_bar(bars).is_some_and(is_of_bar)).then_some(negative)
}

/// The least criterion of the laws of a simple pendulum, for residuals of the same quantity: without uncertainties the laws of bars have residuals
/// of T, those of strings of T².
fn aicc_of_strings(table: &LengthTable) -> f64 {
    let equal = table.of_equal_periods();
    let simple = [LengthModel::Plain, LengthModel::Offset].into_iter();
    let simple = simple.filter_map(|model| model::fit(&equal, model, None).ok().flatten()?.aicc_of(table));
    simple.fold(f64::INFINITY, f64::min)
}

/// Returns `true` if the rows are those of a bar, and determine its g: the periods fall with the distance at the shortest ones or the centre of mass is
/// between the positions, and Akaike's criterion separates the law from that of a simple pendulum.
fn is_bar(bars: &[LengthFit], table: &LengthTable) -> bool {
    let Some(bar) = preferred_bar(bars) else { return false };
    let offset = bar.offset.map_or(0.0, |offset| offset.value);
    let distances = || table.rows.iter().map(|row| row.length + offset);
    let shortest = distances().map(f64::abs).fold(f64::INFINITY, f64::min);
    let falls = bar.gyration.is_some_and(|gyration| gyration.value > shortest * shortest);
    let is_on_both_sides =
        distances().any(|distance| distance < 0.0) && distances().any(|distance| distance > 0.0);
    let is_separated = bar.aicc.is_some_and(|aicc| aicc + SEPARATED < aicc_of_strings(table));
    is_determined(bar) && (falls || is_on_both_sides) && is_separated
}

fn is_determined(fit: &LengthFit) -> bool {
    fit.g.relative() < warning::UNDETERMINED
}

fn of_bars(
    table: &LengthTable,
    options: &LengthsOptions,
    uncorrected: &[LengthFit],
) -> Result<LengthsFit, FitError> {
    let preferred = preferred_bar(uncorrected).ok_or(FitError::NoBar)?.model;
    let corrected = options.corrected(table, preferred)?;
    let fits = if corrected == *table { uncorrected.to_vec() } else { bars(&corrected, options) };
    let mut fit = options.with_budget(table, fits, preferred, None)?;
    let outlying = outlying::outlying(&corrected, &|table: &LengthTable| bar::fit(table, preferred), None);
    fit.warnings = warning::of_bars(fit.best(), &fit.combined, options.pendulum.is_none(), outlying);
    Ok(fit)
}

fn of_reversible(table: &LengthTable, options: &LengthsOptions) -> Result<LengthsFit, FitError> {
    let corrected = options.corrected(table, LengthModel::Reversible)?;
    let (fit, contributions) = reversible::reversible(&corrected, options.edges)?;
    let mut fit = options.with_budget(table, vec![fit], LengthModel::Reversible, Some(contributions))?;
    fit.warnings = warning::of_bars(fit.best(), &fit.combined, false, None);
    Ok(fit)
}

impl LengthsOptions {
    fn check(&self) -> Result<(), FitError> {
        let usable = |spread: f64| (0.0..f64::INFINITY).contains(&spread);
        if let Some(Quantity { value, uncertainty }) = self.corrections.bob.map(|bob| bob.radius) {
            let uncertainty = uncertainty.unwrap_or(0.0);
            if !(value > 0.0 && value.is_finite() && usable(uncertainty)) {
                return Err(FitError::Length { value, uncertainty });
            }
        }
        self.corrections.values()?;
        self.clock.filter(|clock| !usable(*clock)).map_or(Ok(()), |clock| Err(FitError::Clock(clock)))
    }

    /// Radius of a ball with the moment of inertia of the bob.
    fn bob_radius(&self) -> Option<f64> {
        self.corrections.bob.map(|bob| bob.radius_of_ball())
    }

    /// The standard uncertainty of the periods by the common error of all readings, as a fraction of their sum.
    fn relative_shift(&self, table: &LengthTable) -> Option<f64> {
        let shifts = self.shared_timing.as_ref()?;
        Some(shifts.iter().sum::<f64>() / table.rows.iter().map(|row| row.period).sum::<f64>())
    }

    /// The table with the periods that a law describes.
    fn corrected(&self, table: &LengthTable, model: LengthModel) -> Result<LengthTable, FitError> {
        if self.corrections == Corrections::default() {
            return Ok(table.clone());
        }
        let values = self.corrections.values()?;
        let law = CorrectedLaw { table, options: self, model };
        law.table(&values, None)
    }

    /// The results with the uncertainty of g: by the slope of the line, or the contributions of a reversible pendulum, and by all corrections.
    fn with_budget(
        &self,
        table: &LengthTable,
        fits: Vec<LengthFit>,
        preferred: LengthModel,
        stated: Option<Vec<Contribution>>,
    ) -> Result<LengthsFit, FitError> {
        let best =
            fits.iter().find(|fit| fit.model == preferred).ok_or(FitError::NoConvergence("the line"))?;
        let inputs = stated.unwrap_or_else(|| vec![slope(best)]);
        let budget = CorrectedLaw { table, options: self, model: preferred }.budget(best)?;
        let row = |contribution: &Contribution| match contribution.input {
            BudgetInput::Slope => budget::input_row(
                contribution,
                "u(s)/s",
                "s: slope of T^2/(2pi R)^2 against the length".into(),
            ),
            _ => budget::input_row(contribution, "u(g)/g", "of the reversible pendulum".into()),
        };
        let rows: Vec<BudgetRow> = inputs.iter().map(row).chain(budget.rows).collect();
        let contributions = [inputs, budget.contributions].concat();
        let combined =
            CombinedUncertainty::new(contributions, &[]).map_err(|_| FitError::NoConvergence("the line"))?;
        Ok(LengthsFit {
            fits,
            preferred,
            power_law: None,
            known_gyration: None,
            combined,
            budget: rows,
            weighted_by_rounding: false,
            warnings: vec![],
        })
    }
}

/// The contribution of the fitted line.
fn slope(best: &LengthFit) -> Contribution {
    let g = best.g.value;
    Contribution {
        evaluation: Evaluation::Statistics,
        degrees_of_freedom: best.uncertainty_degrees_of_freedom(),
        ..Contribution::judged(BudgetInput::Slope, 1.0 / g, Some(best.g.uncertainty / (g * g)), -g * g)
    }
}
