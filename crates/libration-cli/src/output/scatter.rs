//! How rows scatter beside their stated uncertainties.

use super::json::Record;
use libration_lab::fit::Scatter;

/// What stands behind an uncertainty that was enlarged: `  (± is enlarged 1.52 times: …)`; empty for others.
pub(crate) fn remark(scatter: Option<Scatter>) -> String {
    scatter.and_then(Scatter::enlarged).map_or(String::new(), |enlarged| format!("  ({enlarged})"))
}

/// The Birge ratio, and by what the uncertainties are enlarged; null without stated ones.
pub(crate) fn fields(record: Record, scatter: Option<Scatter>) -> Record {
    const NONE: &str = "the table has no uncertainties of the periods, or no row to spare";
    record
        .number_or("birge_ratio", scatter.map(Scatter::birge_ratio), NONE)
        .number("uncertainties_enlarged_by", scatter.map_or(1.0, Scatter::enlargement))
}
