//! Scatter of rows compared with their stated uncertainties.

use super::field::Field;
use libration_lab::fit::Scatter;

/// The reason why there is no χ² per degree of freedom.
pub(crate) const NO_SCATTER: &str = "the table has no uncertainties of the periods, or too few rows";

/// The remark after an uncertainty that was enlarged: `  (± is enlarged 1.52 times: …)`; empty for others.
pub(crate) fn remark(scatter: Option<Scatter>) -> String {
    scatter.and_then(Scatter::enlarged).map_or(String::new(), |enlarged| format!("  ({enlarged})"))
}

/// A field with the Birge ratio, or the reason why there is none.
pub(crate) fn birge_ratio_field<A>(value: fn(&A) -> Result<f64, String>) -> Field<A> {
    let meaning = "√(χ²/dof): the scatter of the rows over what was stated, or null";
    Field::known("birge_ratio", "1", meaning, value).only_json()
}

pub(crate) fn birge_ratio(scatter: Option<Scatter>) -> Result<f64, String> {
    scatter.map(Scatter::birge_ratio).ok_or_else(|| NO_SCATTER.to_owned())
}

/// A field with the factor by which uncertainties are enlarged.
pub(crate) fn enlargement_field<A>(value: fn(&A) -> Option<f64>) -> Field<A> {
    let meaning = "factor by which the scatter enlarged the uncertainties";
    Field::present("uncertainties_enlarged_by", "1", meaning, value).only_json()
}

/// 1 where uncertainties are as stated, or from the scatter alone.
pub(crate) fn enlargement(scatter: Option<Scatter>) -> f64 {
    scatter.map_or(1.0, Scatter::enlargement)
}
