//! Detection of a row that does not follow the law of all others.

use super::model::{self, LengthFit, LengthModel};
use super::table::LengthTable;
use super::warning::LengthsWarning;
use crate::fit::uncertain::Uncertain;
use crate::statistics::count;
use crate::statistics::student::probability_beyond_any;

/// The probability that chance puts any row as far from the law of the others: the warning is given for one in a hundred tables without a mistake.
const CHANCE: f64 = 0.01;
/// Largest number of rows for the detection: larger tables are not typed by hand, and one row of them matters little.
const MOST_ROWS: usize = 200;

/// The row that is farthest from the law of the others, if chance does not explain its distance: by the externally studentised residual of T, with
/// Bonferroni's bound for the choice of the row. None where a law with one parameter more leaves a smaller sum of squares of all rows.
///
/// # References
/// R. D. Cook and S. Weisberg, *Residuals and Influence in Regression*, Chapman and Hall 1982, section 2.2.2.
pub(super) fn outlying(
    table: &LengthTable,
    fit: &dyn Fn(&LengthTable) -> Option<LengthFit>,
    wider: Option<LengthModel>,
) -> Option<LengthsWarning> {
    let equal = table.of_equal_periods();
    let rows = equal.len();
    let whole = fit(&equal).filter(|_| rows <= MOST_ROWS)?;
    let dof = rows.checked_sub(whole.model.parameters() + 1).filter(|dof| *dof > 1)?;
    let others = |row: usize| (0..rows).filter(|other| *other != row).collect::<Vec<_>>();
    let deviation = |row: usize| {
        let without = fit(&equal.only(&others(row)))?.sum_of_squares();
        let variance = without / count(dof);
        let variance = if table.is_weighted() { variance.max(1.0) } else { variance };
        Some(((whole.sum_of_squares() - without).max(0.0) / variance).sqrt())
    };
    let deviations = (0..rows).filter_map(|row| Some((row, deviation(row)?)));
    let (row, deviation) = deviations.max_by(|one, other| one.1.total_cmp(&other.1))?;
    if count(rows) * probability_beyond_any(deviation, count(dof)) > CHANCE {
        return None;
    }
    let of_wider = wider.and_then(|wider| Some(model::fit(&equal, wider, None).ok()??.sum_of_squares()));
    let of_others = fit(&equal.only(&others(row)))?.sum_of_squares();
    if of_wider.is_some_and(|wider| wider < of_others) {
        return None;
    }
    let gravity: Uncertain = fit(&table.only(&others(row)))?.g;
    Some(LengthsWarning::Outlying { row, gravity })
}
