//! A formula with its leading error, and a table of the errors of all formulas.

use super::super::check::{Check, CheckedEquation, DerivationError, Given, failed, same_series_where};
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{DecimalUnit, Formula, Name, Statement, agm, monomial, number, order, rounded};
use super::super::prose::Prose;
use super::super::trials::Trials;
use super::super::words::{amplitude, cos_half_amplitude, period, small_swing_period, theta_0};
use libration::period_formulas::PeriodFormula;

/// The keys of the formulas derived here, each with the subscript of its period.
const DERIVED: [(&str, &str); 10] = [
    ("small_angle", "0"),
    ("bernoulli", "Ber"),
    ("molina", "Mol"),
    ("kidd_fogg", "KF"),
    ("carvalhaes_suppes", "CS"),
    ("belendez", "Bel"),
    ("butikov", "But"),
    ("denman", "De"),
    ("black_vel_2", "BV2"),
    ("black_vel_3", "BV3"),
];

/// T with the subscript of a formula.
pub(super) fn period_of(mark: &str) -> Name {
    Name::new("T").word(mark)
}

/// 1/agm(1, cos(θ0/2)).
pub(super) fn exact_ratio() -> Formula {
    number(1) / agm(1, cos_half_amplitude())
}

/// The formula with this key and subscript, checked against the catalogue.
pub(super) fn stated(
    trials: &Trials,
    key: &str,
    mark: &str,
    ratio: Formula,
) -> Result<CheckedEquation, DerivationError> {
    let statement = Statement::defined(Formula::from(period_of(mark)) / small_swing_period(), ratio.clone());
    let catalogued = catalogued(key)?;
    trials.agrees_with(&statement, &ratio, |angle| catalogued.period_ratio(angle))?;
    let leading_error = catalogued.leading_error().map(|error| (error.coefficient.clone(), error.power));
    Ok(CheckedEquation::new(statement, Check::Catalogued { key: key.to_owned(), leading_error }))
}

/// The leading term of a formula's error, checked against the catalogue.
pub(super) fn leading_error(
    key: &str,
    mark: &str,
    ratio: Formula,
) -> Result<CheckedEquation, DerivationError> {
    let name = period_of(mark);
    let formula = catalogued(key)?;
    let Some(leading) = formula.leading_error() else {
        return Err(failed(&Statement::from(ratio), format!("the catalogue has no leading error of {key}")));
    };
    let power = usize::try_from(leading.power).unwrap_or(usize::MAX);
    let next = i64::from(leading.power) + 2;
    let error = monomial(&leading.coefficient, &theta_0(), power) + order(theta_0().pow(next));
    let statement = Statement::equal(Formula::from(&name) / period() - 1, error);
    let given = [Given::Value(Name::new("T"), exact_ratio()), Given::Value(name, ratio)];
    same_series_where(&amplitude(), power + 2, &given, statement)
}

/// The formula of the catalogue with this key.
pub(super) fn catalogued(key: &str) -> Result<PeriodFormula, DerivationError> {
    PeriodFormula::by_key(key)
        .map_err(|error| DerivationError::Failed { formula: key.to_owned(), reason: error.to_string() })
}

pub(super) fn all_at_one_amplitude(trials: &Trials) -> Result<DerivationStep, DerivationError> {
    let head = ["formula", "period", "leading error", "error here"].map(Prose::text);
    let angle = trials.angle();
    let mut rows = Vec::new();
    for (key, mark) in DERIVED {
        let formula = catalogued(key)?;
        let leading = formula.leading_error().map_or_else(
            || Prose::text("none at small swings"),
            |leading| {
                let power = usize::try_from(leading.power).unwrap_or(usize::MAX);
                Prose::formula(monomial(&leading.coefficient, &theta_0(), power))
            },
        );
        rows.push(vec![
            Prose::text(formula.name()),
            Prose::formula(period_of(mark).into()),
            leading,
            Prose::formula(rounded(formula.fractional_error(&angle), 2, DecimalUnit::One)),
        ]);
    }
    let note = Prose::text(
        "errors here from the catalogue of formulas, which computes them in as many digits as it takes",
    );
    Ok(DerivationStep::new("side-by-side", "Side by side")
        .say("All of them at an amplitude of {}, where the exact ratio is {}:", [
            trials.amplitude(),
            rounded(trials.value(&exact_ratio())?.to_f64(), 11, DecimalUnit::One),
        ])
        .table(DerivationTable::numbers(head.into(), rows, note))
        .remark(
            "Two steps of the mean, with one square root, are better than any formula with a polynomial here at almost every \
             amplitude; a third step costs another root and is exact to many digits.",
            [],
        ))
}
