//! Fields of measured periods, and of each law.

use super::input::ReadPeriods;
use crate::arguments::of_columns;
use crate::call::in_words;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::groups::{self, Groups};
use crate::output::normal_gravity::{self, NormalGravity};
use crate::output::warnings::{self, NamedWarning};
use crate::output::{budget, json, scatter};
use libration::quantity::Quantity;
use libration_lab::fit::{Budget, FitError, LawFit, PeriodFit, Weighting};

/// The result for the measurements.
pub(super) struct FitPeriodsResult<'a> {
    pub(super) measured: &'a ReadPeriods,
    pub(super) fit: &'a PeriodFit,
    pub(super) groups: Option<&'a Groups>,
    pub(super) budget: Option<&'a Budget>,
    pub(super) length: Option<Quantity>,
    pub(super) normal: Option<NormalGravity>,
}

/// A law with its key, and its fit or the reason why there is none.
pub(super) struct KeyedLaw<'a> {
    key: &'a str,
    fit: Result<&'a LawFit, &'a FitError>,
}

impl FitPeriodsResult<'_> {
    /// The exact law, the constant period, the formulas.
    pub(super) fn laws(&self) -> Vec<KeyedLaw<'_>> {
        let fixed = [&self.fit.exact, &self.fit.constant].map(|law| KeyedLaw { key: &law.key, fit: Ok(law) });
        let others = self.fit.others.iter().map(|(key, law)| KeyedLaw { key, fit: law.as_ref() });
        fixed.into_iter().chain(others).collect()
    }

    /// The warnings about the rows, and about gravity, with stable names.
    pub(super) fn warnings(&self) -> Vec<NamedWarning> {
        let of_rows = self.fit.warnings().into_iter().map(|warning| (warning.name(), warning.to_string()));
        of_rows.chain(self.budget.into_iter().flat_map(budget::warnings)).collect()
    }

    pub(super) fn outlier_lines(&self) -> Vec<u64> {
        self.fit.outliers.iter().filter_map(|&row| self.measured.lines.get(row).copied()).collect()
    }

    pub(super) fn weighting(&self) -> &'static str {
        match self.fit.weighting {
            Weighting::PeriodsAndAmplitudes => "uncertainties of periods and amplitudes",
            Weighting::Periods => "uncertainties of periods",
            Weighting::Rounding => "rounding of the periods: the rows scatter less",
            Weighting::Scatter => "none: uncertainties from the scatter",
        }
    }
}

pub(super) fn of_answer<'a>() -> Fields<FitPeriodsResult<'a>> {
    type Of<'a> = Field<FitPeriodsResult<'a>>;
    let before = Fields::from([
        Of::value("rows", "1", "rows that were fitted", |result| result.fit.table.len().into()),
        Of::value("rows_incomplete", "1", "rows left out because a number is missing", |result| {
            result.measured.dropped.into()
        }),
        Of::value("told_from_file[]", "", "settings inferred from the file", |result| {
            json::list(result.measured.inferences.sentences.clone())
        }),
        Of::nested("read_columns[].", &of_columns(), |result| {
            of_columns().records(&result.measured.inferences.columns)
        }),
        Of::value("weighting", "", "weights of the rows", |result| result.weighting().into()),
        Of::value(
            "outlier_lines[]",
            "1",
            "lines of the file whose period is far from the exact law",
            |result| json::list(result.outlier_lines()),
        ),
        Of::nested("laws[].", &of_law(), |result| of_law().records(&result.laws())),
    ]);
    let warnings = warnings::fields(
        |result: &FitPeriodsResult<'a>| warnings::texts(result.warnings()),
        |result| warnings::names(result.warnings()),
    );
    before.and(warnings).and([
        Of::known(
            "beta",
            "1",
            "measured rise of the period with the amplitude over that of the exact law, 1 if it holds",
            |result| result.fit.beta.as_ref().map(|beta| beta.beta.factor.value).map_err(ToString::to_string),
        ),
        Of::known("beta_uncertainty", "1", "standard uncertainty of β", |result| {
            result.fit.beta.as_ref().map(|beta| beta.beta.factor.uncertainty).map_err(ToString::to_string)
        }),
        Of::known(
            "beta_uncertainty_scaled",
            "1",
            "that uncertainty enlarged by the scatter of the rows, or null",
            |result| {
                let scaled = result.fit.beta.as_ref().ok().and_then(|beta| beta.uncertainty_scaled);
                scaled.ok_or_else(|| "chi² per degree of freedom is needed to scale it".to_owned())
            },
        ),
        Of::known(
            "gravity_m_per_s2",
            "m/s²",
            "acceleration of free fall, or null without a length",
            |result| result.budget.map(|budget| budget.g).ok_or_else(no_gravity),
        ),
        Of::known(
            "gravity_uncertainty_m_per_s2",
            "m/s²",
            "standard uncertainty of gravity, or null",
            |result| result.budget.map(|budget| budget.uncertainty).ok_or_else(no_gravity),
        ),
    ])
}

fn no_gravity() -> String {
    in_words("give <--length> to obtain gravity")
}

pub(super) fn of_law<'a>() -> Fields<KeyedLaw<'a>> {
    type Of<'a> = Field<KeyedLaw<'a>>;
    Fields::from([
        Of::value("key", "", "law of the period: exact, constant, or a formula", |law| law.key.into())
            .words("law", |law| law.key.to_owned()),
        scatter::birge_ratio_field(|row: &KeyedLaw<'a>| {
            row.fit.map_or_else(|_| Err(String::new()), |law| scatter::birge_ratio(law.scatter()))
        }),
        scatter::enlargement_field(|row: &KeyedLaw<'a>| {
            row.fit.ok().map(|law| scatter::enlargement(law.scatter()))
        }),
        Of::nullable("t0_s", "s", "period of small swings T₀ under this law", |row| {
            row.fit.ok().map(|law| law.t0.value)
        })
        .rounded("T₀ / s", 8)
        .or("–"),
        Of::nullable("t0_uncertainty_s", "s", "standard uncertainty of T₀", |row| {
            row.fit.ok().map(|law| law.t0.uncertainty)
        })
        .rounded("± / s", 2)
        .or("–"),
        Of::known("chi2_per_dof", "1", "χ² per degree of freedom, or null", |law| {
            let chi2 = law.fit.map_err(|_| String::new())?.chi2_per_dof();
            chi2.ok_or_else(|| scatter::NO_SCATTER.to_owned())
        })
        .rounded("χ²/dof", 4)
        .or("–"),
        Of::nullable("rms_s", "s", "root mean square of the residuals", |row| {
            row.fit.ok().map(|law| law.rms)
        })
        .rounded("rms residual / s", 3)
        .or("–"),
        Of::note(|law| law.fit.err().map(ToString::to_string)),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let (json, csv) = (
        [
            of_answer().described(""),
            normal_gravity::fields().described(""),
            groups::fields(&groups::T0).described(""),
            budget::described(),
        ]
        .concat(),
        of_law().described_in_csv(),
    );
    vec![Answers { command: "fit periods", option: "", json, csv }]
}
