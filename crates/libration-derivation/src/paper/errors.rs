//! The exact errors of the formulas that are compared with each other: their
//! crossovers, the ranges in which they keep a tolerance, and the best formula.

use std::sync::LazyLock;

use super::amplitudes::in_degrees;
use libration::algebra::Rational;
use libration::period_formulas::{Crossover, ErrorTable, PeriodFormula};
use libration::progress::Quiet;
use libration::quantity::Angle;

/// The formulas that the document plots and names, by the keys of the catalogue.
pub(super) const PLOTTED: [&str; 8] =
    ["denman", "black_vel_2", "black_vel_3", "bernoulli", "molina", "kidd_fogg", "butikov", "power_series_3"];
const OTHERS: [&str; 4] = ["small_angle", "power_series_2", "carvalhaes_suppes", "belendez"];

/// The table of errors, searched once for all claims.
static TABLE: LazyLock<ErrorTable> = LazyLock::new(|| {
    let keys = PLOTTED.iter().chain(&OTHERS);
    let formulas: Vec<_> = keys.filter_map(|key| PeriodFormula::by_key(key).ok()).collect();
    ErrorTable::new(&formulas, &Quiet).expect("nothing cancels it")
});

fn index_of(key: &str) -> Option<usize> {
    TABLE.formulas().position(|formula| formula.key() == key)
}

/// The amplitudes at which the better of two formulas changes.
pub(super) fn crossings(a: &str, b: &str) -> Option<Vec<Crossover>> {
    Some(TABLE.crossovers(index_of(a)?, index_of(b)?))
}

/// The intervals in radians on which |error of a| < |error of b|.
pub(super) fn better_on(a: &str, b: &str) -> Option<Vec<(f64, f64)>> {
    let inner = crossings(a, b)?.into_iter().map(|crossing| crossing.amplitude.radians());
    let bounds: Vec<f64> = [0.0].into_iter().chain(inner).chain([std::f64::consts::PI]).collect();
    let mut intervals: Vec<(f64, f64)> = Vec::new();
    for pair in bounds.windows(2) {
        let middle = f64::midpoint(pair[0], pair[1]);
        if error(a, middle)?.abs() < error(b, middle)?.abs() {
            intervals.push((pair[0], pair[1]));
        }
    }
    Some(intervals)
}

/// The amplitudes at which |error of a| is this many times |error of b|.
pub(super) fn ratio_reached(a: &str, b: &str, factor: f64) -> Option<Vec<f64>> {
    let amplitudes = TABLE.amplitudes_where_ratio_of_errors(index_of(a)?, index_of(b)?, factor);
    Some(amplitudes.iter().map(Angle::radians).collect())
}

/// |error of a|/|error of b| at an amplitude in degrees.
pub(super) fn ratio_at(a: &str, b: &str, degrees: f64) -> Option<f64> {
    Some((error_at(a, degrees)? / error_at(b, degrees)?).abs())
}

/// The quotient of exact leading errors of the same power.
pub(super) fn ratio_of_leading_errors(a: &str, b: &str) -> Option<Rational> {
    let leading = |key: &str| PeriodFormula::by_key(key).ok()?.leading_error().cloned();
    let (a, b) = (leading(a)?, leading(b)?);
    (a.power == b.power).then(|| a.coefficient.checked_div(&b.coefficient)).flatten()
}

/// The fractional error at an amplitude in radians.
pub(super) fn error(key: &str, radians: f64) -> Option<f64> {
    let formula = TABLE.formulas().nth(index_of(key)?)?;
    Some(formula.fractional_error_at(radians))
}

/// The fractional error at an amplitude in degrees.
pub(super) fn error_at(key: &str, degrees: f64) -> Option<f64> {
    let formula = TABLE.formulas().nth(index_of(key)?)?;
    Some(formula.fractional_error(&Angle::from_degrees(degrees).ok()?))
}

/// The intervals in radians on which the error keeps a tolerance.
pub(super) fn holds_on(key: &str, tolerance: f64) -> Option<Vec<(f64, f64)>> {
    Some(TABLE.holds_on(index_of(key)?, tolerance))
}

/// The amplitudes at which a formula is exact.
pub(super) fn exact_at(key: &str) -> Option<Vec<f64>> {
    Some(TABLE.amplitudes_where_exact(index_of(key)?).iter().map(Angle::radians).collect())
}

/// The best formulas of a set, from the smallest amplitude on, each with the amplitude up to which it is the best.
pub(super) fn leaders(keys: &[&str]) -> Option<Vec<(String, f64)>> {
    let pairs = keys.iter().enumerate().flat_map(|(i, a)| keys[i + 1..].iter().map(move |b| (a, b)));
    let mut bounds = vec![std::f64::consts::PI];
    for (a, b) in pairs {
        bounds.extend(crossings(a, b)?.iter().map(|crossing| crossing.amplitude.radians()));
    }
    bounds.sort_by(f64::total_cmp);
    let mut leaders: Vec<(String, f64)> = Vec::new();
    let mut from = 0.0;
    for to in bounds {
        let best = best_at(keys, f64::midpoint(from, to))?;
        match leaders.last_mut() {
            Some(last) if last.0 == best => last.1 = to,
            _ => leaders.push((best, to)),
        }
        from = to;
    }
    Some(leaders)
}

fn best_at(keys: &[&str], radians: f64) -> Option<String> {
    let errors =
        keys.iter().map(|key| Some((*key, error(key, radians)?.abs()))).collect::<Option<Vec<_>>>()?;
    errors.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(key, _)| key.to_owned())
}

/// Formats like `black_vel_3 to 129.4407756 degrees, then …`.
pub(super) fn in_words(leaders: &[(String, f64)]) -> String {
    let (last, inner) = match leaders.split_last() {
        Some((last, inner)) => (last.0.as_str(), inner),
        None => ("", leaders),
    };
    let inner = inner.iter().map(|(key, to)| format!("{key} to {}, then ", in_degrees(*to)));
    format!("{}{last}", inner.collect::<String>())
}

/// Formats like `0 to 77.785 degrees and 138.88 to 142.93 degrees`.
pub(super) fn intervals_in_words(intervals: &[(f64, f64)]) -> String {
    let end = |radians: f64| {
        let degrees = format!("{:.10}", radians.to_degrees());
        degrees.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    let words = intervals.iter().map(|&(from, to)| format!("{} to {} degrees", end(from), end(to)));
    words.collect::<Vec<_>>().join(" and ")
}
