//! `libration figure errors`: the fractional error of the formulas against the amplitude.

use super::PictureOptions;
use crate::arguments::{self, FormulaChoice};
use crate::figure::chart::Picture;
use crate::figure::errors::{ErrorOfFormula, Frame, errors};
use crate::interrupt;
use crate::query_error::{QueryError, option};
use libration::period_formulas::PeriodFormula;
use libration::quantity::Angle;

/// The curves of the first figure of Black and Vel.
const FIRST_FIGURE: [&str; 8] =
    ["bernoulli", "molina", "kidd_fogg", "butikov", "power_series_3", "denman", "black_vel_2", "black_vel_3"];

/// The errors of the formulas against the amplitude, as in the first figure of Black and Vel
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure errors --output errors.svg
  libration figure errors --formulas bernoulli,carvalhaes_suppes \\
    --from 60deg --output errors.png
  libration figure errors --near-top --no-title --output figure1.pdf")
)]
pub(super) struct ErrorsFigure {
    #[command(flatten)]
    formulas: FormulaChoice,
    /// The amplitude at the left end
    #[arg(long, default_value = "0deg", value_parser = arguments::angle)]
    from: Angle,
    /// The amplitude at the right end
    #[arg(long, default_value = "180deg", value_parser = arguments::angle)]
    to: Angle,
    /// The smallest error shown
    #[arg(long, default_value = "1e-8", value_parser = arguments::positive)]
    lowest: f64,
    /// The largest error shown
    #[arg(long, default_value = "10", value_parser = arguments::positive)]
    highest: f64,
    /// Add a panel with the errors against π − θ₀ on a logarithmic axis
    #[arg(long)]
    near_top: bool,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

impl ErrorsFigure {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        let (from, to) = (self.from.degrees(), self.to.degrees());
        if !(0.0 <= from && from < to && to <= 180.0) {
            let got = format!("from {from:?}° to {to:?}°: give 0 ≤ from < to ≤ 180deg");
            return Err(QueryError::no_result([option("from"), option("to")], got));
        }
        if self.lowest >= self.highest {
            let got = format!("{:?} is not below {:?}", self.lowest, self.highest);
            return Err(QueryError::no_result([option("lowest"), option("highest")], got));
        }
        let formulas = self.curves()?;
        interrupt::listen()?;
        let curves: Vec<ErrorOfFormula> = formulas.into_iter().map(curve).collect();
        let (lowest, highest, has_top) = (self.lowest, self.highest, self.near_top);
        Ok(errors(&curves, Frame { from, to, lowest, highest, has_top }))
    }

    fn curves(&self) -> Result<Vec<PeriodFormula>, QueryError> {
        if !self.formulas.chosen().is_empty() {
            return Ok(self.formulas.chosen().to_vec());
        }
        let formulas = FIRST_FIGURE.into_iter().map(PeriodFormula::by_key).collect::<Result<_, _>>();
        formulas.map_err(|error| QueryError::no_result(option("formulas"), error))
    }
}

fn curve(formula: PeriodFormula) -> ErrorOfFormula {
    let (label, family) = (formula.name().to_owned(), formula.family().to_owned());
    ErrorOfFormula { label, family, error: Box::new(move |angle| formula.fractional_error(angle)) }
}
