//! Fields of periods against lengths, and of each law.

use super::input::LengthFile;
use crate::arguments::of_columns;
use crate::call::in_words;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::groups::{self, Groups};
use crate::output::normal_gravity::{self, NormalGravity};
use crate::output::warnings::{self, NamedWarning};
use crate::output::{budget, combined, json, number, scatter};
use libration_lab::fit::{GravityMistake, LengthFit, LengthsFit, LengthsWarning, Uncertain};

/// The result for the measurements.
pub(super) struct FitLengthsResult<'a> {
    pub(super) table: &'a LengthFile,
    pub(super) fit: &'a LengthsFit,
    pub(super) groups: Option<&'a Groups>,
    pub(super) normal: Option<NormalGravity>,
}

impl FitLengthsResult<'_> {
    /// The warnings with the options that help, and names that stay.
    pub(super) fn warnings(&self) -> Vec<NamedWarning> {
        let half = self.table.half_periods;
        let text = |warning: &LengthsWarning| match warning {
            LengthsWarning::NowhereOnEarth { mistake: Some(GravityMistake::HalfPeriodsAsWhole) } if !half => {
                format!("{warning} (<--half-periods>)")
            }
            LengthsWarning::NowhereOnEarth { mistake: Some(GravityMistake::WholePeriodsAsHalf) } if half => {
                format!("{warning} (leave out <--half-periods>)")
            }
            LengthsWarning::NowhereOnEarth { mistake: Some(GravityMistake::CentimetresAsMetres) } => {
                format!("{warning} (<--length-unit=cm>)")
            }
            LengthsWarning::NowhereOnEarth { mistake: Some(GravityMistake::WholePeriodsAsHalf) } => {
                format!("{warning} (<--swings-per-reading=2>)")
            }
            LengthsWarning::NowhereOnEarth { mistake: Some(GravityMistake::SwingsAsOne(number)) } => {
                let unit = if *number == 10 { ", <--length-unit=m>" } else { "" };
                format!("{warning} (<--swings-per-reading={number}>{unit})")
            }
            LengthsWarning::PhysicalPendulum { .. } => format!("{warning} (<--model=simple> to fit that)"),
            LengthsWarning::Bent { radius: Some(_) } => format!("{warning} (<--bob-radius>)"),
            LengthsWarning::OffsetLargerThanBob => format!("{warning} (<--length-unit=m|cm>)"),
            LengthsWarning::OtherPower { .. } => format!("{warning} (<--columns>)"),
            _ => warning.with_lines(&self.table.lines),
        };
        self.fit.warnings.iter().map(|warning| (warning.name(), in_words(&text(warning)))).collect()
    }

    pub(super) fn weighting(&self) -> &'static str {
        match (
            self.table.measured.period_uncertainties.is_some(),
            self.table.measured.length_uncertainties.is_some(),
        ) {
            (true, true) => "uncertainties of periods and lengths",
            (true, false) => "uncertainties of periods",
            (false, _) => "none: uncertainties from the scatter",
        }
    }

    /// The offset of the preferred law, or the reason why it is undecided.
    fn offset(&self) -> Result<Uncertain, String> {
        self.fit.best().offset.ok_or_else(|| match self.fit.best().model.is_of_bars() {
            true => "the positions are measured from the centre of mass".to_owned(),
            false => "the rows do not determine an offset".to_owned(),
        })
    }

    /// k of a bar.
    pub(super) fn radius_of_gyration(&self) -> Result<Uncertain, String> {
        let best = self.fit.best();
        let square = best.gyration.filter(|_| best.model.is_of_bars());
        let radius = |square: Uncertain| {
            let value = square.value.sqrt();
            Uncertain { value, uncertainty: 0.5 * square.uncertainty / value }
        };
        square.map(radius).ok_or_else(|| "not fitted by this law".to_owned())
    }
}

pub(super) fn of_answer<'a>() -> Fields<FitLengthsResult<'a>> {
    type Of<'a> = Field<FitLengthsResult<'a>>;
    let before = Fields::from([
        Of::value("rows", "1", "rows that were fitted", |result| result.table.measured.table.len().into()),
        Of::value("rows_incomplete", "1", "rows left out because a number is missing", |result| {
            result.table.dropped.into()
        }),
        Of::value("told_from_file[]", "", "settings inferred from the file", |result| {
            json::list(result.table.inferences.sentences.clone())
        }),
        Of::nested("read_columns[].", &of_columns(), |result| {
            of_columns().records(&result.table.inferences.columns)
        }),
        Of::value("weighting", "", "weights of the rows", |result| result.weighting().into()),
        Of::value("law", "", "law that the data prefer, from which gravity is computed", |result| {
            result.fit.best().model.name().into()
        }),
        Of::number("gravity_m_per_s2", "m/s²", "acceleration of free fall", |result| {
            result.fit.best().g.value
        }),
        Of::number("gravity_uncertainty_m_per_s2", "m/s²", "standard uncertainty of gravity", |result| {
            result.fit.combined.standard
        }),
        Of::known("offset_m", "m", OFFSET, |result| result.offset().map(|offset| offset.value)),
        Of::known("offset_uncertainty_m", "m", "standard uncertainty of that length, or null", |result| {
            result.offset().map(|offset| offset.uncertainty)
        }),
        Of::known("radius_of_gyration_m", "m", "k of a bar about its centre of mass, or null", |result| {
            result.radius_of_gyration().map(|radius| radius.value)
        }),
        Of::known("radius_of_gyration_uncertainty_m", "m", "standard uncertainty of k, or null", |result| {
            result.radius_of_gyration().map(|radius| radius.uncertainty)
        }),
        Of::known("exponent", "1", "n of T = a·Lⁿ, 1/2 of a simple pendulum, or null", |result| {
            result.fit.power_law.map(|law| law.exponent.value).ok_or_else(|| NO_POWER.to_owned())
        }),
        Of::known("exponent_uncertainty", "1", "standard uncertainty of n, or null", |result| {
            result.fit.power_law.map(|law| law.exponent.uncertainty).ok_or_else(|| NO_POWER.to_owned())
        }),
        Of::nested("laws[].", &of_law(), |result| of_law().records(&result.fit.fits)),
    ]);
    let warnings = warnings::fields(
        |result: &FitLengthsResult<'a>| warnings::texts(result.warnings()),
        |result| warnings::names(result.warnings()),
    );
    before.and(warnings).and([
        scatter::birge_ratio_field(|result: &FitLengthsResult<'a>| {
            scatter::birge_ratio(result.fit.best().scatter())
        }),
        scatter::enlargement_field(|result: &FitLengthsResult<'a>| {
            Some(scatter::enlargement(result.fit.best().scatter()))
        }),
    ])
}

const NO_POWER: &str = "a bar does not follow a power law, or there are fewer than three rows";

const OFFSET: &str = "length to be added to all measured ones, or null";
const COLUMNS: [&str; 8] = ["law", "g / m/s²", "± / m/s²", "δ / mm", "± / mm", "χ²/dof", "AICc", "by chance"];

pub(super) fn of_law() -> Fields<LengthFit> {
    type Of = Field<LengthFit>;
    Fields::from([
        scatter::birge_ratio_field(|fit: &LengthFit| scatter::birge_ratio(fit.scatter())),
        scatter::enlargement_field(|fit: &LengthFit| Some(scatter::enlargement(fit.scatter()))),
        Of::value("law", "", "free parameters of this law besides gravity", |fit| fit.model.name().into())
            .words(COLUMNS[0], |fit| fit.model.name().to_owned()),
        Of::number("g_m_per_s2", "m/s²", "acceleration of free fall under this law", |fit| fit.g.value)
            .rounded(COLUMNS[1], 6),
        Of::number("g_uncertainty_m_per_s2", "m/s²", "standard uncertainty of that", |fit| fit.g.uncertainty)
            .numeral(COLUMNS[2], |fit| or_dash(Some(fit.g.uncertainty), 2)),
        Of::known("offset_m", "m", OFFSET, |fit| fit.offset.map(|offset| offset.value).ok_or_else(not_free))
            .numeral(COLUMNS[3], |fit| or_dash(fit.offset.map(|offset| 1e3 * offset.value), 4)),
        Of::known("offset_uncertainty_m", "m", "standard uncertainty of that length, or null", |fit| {
            fit.offset.map(|offset| offset.uncertainty).ok_or_else(not_free)
        })
        .numeral(COLUMNS[4], |fit| or_dash(fit.offset.map(|offset| 1e3 * offset.uncertainty), 2)),
        Of::known("gyration_m2", "m²", "square of the radius of gyration of the bob, or null", |fit| {
            fit.gyration.map(|gyration| gyration.value).ok_or_else(not_free)
        })
        .only_json(),
        Of::known("gyration_uncertainty_m2", "m²", "standard uncertainty of that, or null", |fit| {
            fit.gyration.map(|gyration| gyration.uncertainty).ok_or_else(not_free)
        })
        .only_json(),
        Of::known(
            "correlation_of_g_and_offset",
            "1",
            "correlation coefficient of gravity and offset, or null",
            |fit| fit.correlation.ok_or_else(not_free),
        )
        .only_json(),
        Of::known("chi2_per_dof", "1", "χ² per degree of freedom, or null", |fit| {
            fit.chi2_per_dof().ok_or_else(|| scatter::NO_SCATTER.to_owned())
        })
        .rounded(COLUMNS[5], 4)
        .or("–"),
        Of::value("dof", "1", "degrees of freedom", |fit| fit.dof.into()).only_json(),
        Of::known("aicc", "1", "Akaike's criterion, corrected for few rows, or null", |fit| {
            fit.aicc.ok_or_else(|| "too few rows".to_owned())
        })
        .rounded(COLUMNS[6], 5)
        .or("–"),
        Of::known(
            "chance_of_last_parameter",
            "1",
            "p-value of the last free parameter: probability of one at least as large by chance if it is zero, or null",
            |fit| fit.p_value.ok_or_else(|| "nothing but g is free, or too few rows".to_owned()),
        )
        .only_json()
        .numeral(COLUMNS[7], |fit| match fit.p_value {
            Some(chance) if chance < 1e-15 => "<1e-15".to_owned(),
            chance => or_dash(chance, 2),
        }),
    ])
}

fn not_free() -> String {
    "not free in this law".to_owned()
}

fn or_dash(value: Option<f64>, digits: usize) -> String {
    value.filter(|value| !value.is_nan()).map_or("–".to_owned(), |value| number::rounded(value, digits))
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        of_answer().described(""),
        normal_gravity::fields().described(""),
        budget::rows_described(),
        combined::of_independent().described(""),
        groups::fields(&groups::GRAVITY).described(""),
    ]
    .concat();
    vec![Answers { command: "fit lengths", option: "", json, csv: of_law().described_in_csv() }]
}
