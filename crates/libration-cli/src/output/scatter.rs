//! How rows scatter beside their stated uncertainties.

use super::json::Record;
use super::number;
use libration_lab::fit::Scatter;

/// What stands behind an uncertainty that was enlarged: `  (1.04 times what was stated, by the scatter)`; empty for others.
pub(crate) fn remark(scatter: Option<Scatter>) -> String {
    let enlarged = scatter.map(Scatter::enlargement).filter(|factor| *factor > 1.0);
    enlarged.map_or(String::new(), |factor| {
        format!("  (± is enlarged {} times: the rows scatter more than stated)", number::rounded(factor, 3))
    })
}

/// The Birge ratio, and by what the uncertainties are enlarged; null without stated ones.
pub(crate) fn fields(record: Record, scatter: Option<Scatter>) -> Record {
    const NONE: &str = "the table has no uncertainties of the periods, or no row to spare";
    record
        .number_or("birge_ratio", scatter.map(Scatter::birge_ratio), NONE)
        .number("uncertainties_enlarged_by", scatter.map_or(1.0, Scatter::enlargement))
}
