//! Fields of a fit of amplitudes, of its coefficients, of each law and of each row.

use super::input::AmplitudeFile;
use crate::arguments::of_columns;
use crate::call::in_words;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::warnings::{self, NamedWarning};
use crate::output::{json, number, scatter};
use libration_lab::fit::amplitudes::{
    AmplitudesFit, AmplitudesWarning, DampingCoefficient, LawOfAmplitudes, Position, Sides, UnstatedErrors,
};
use libration_lab::fit::{DampingKind, Quality, Uncertain};

/// The result for the measurements.
pub(super) struct FitAmplitudesResult<'a> {
    pub(super) file: &'a AmplitudeFile,
    pub(super) fit: &'a AmplitudesFit,
}

/// A coefficient with the units of the table.
pub(super) struct LawCoefficient {
    pub(super) of: DampingCoefficient,
    pub(super) unit: String,
    pub(super) rate_unit: String,
}

/// A row with its predicted value.
struct PredictedRow {
    position: f64,
    value: f64,
    fitted: f64,
    residual: f64,
}

fn no_period() -> String {
    in_words("the period is not known: give <--period>, a column of periods, or times with numbers of swings")
}

const ONE_SIDE: &str = "the rows are amplitudes of one side, which do not determine the zero";

impl FitAmplitudesResult<'_> {
    /// The warnings with the options that help.
    pub(super) fn warnings(&self) -> Vec<NamedWarning> {
        let text = |warning: &AmplitudesWarning| match warning {
            AmplitudesWarning::LawRefuted { .. } | AmplitudesWarning::TooFewRowsToCompare => {
                format!("{warning} (<--model>)")
            }
            AmplitudesWarning::StrongDamping { .. } => format!("{warning} (<libration fit trace>)"),
            _ => warning.to_string(),
        };
        self.fit.warnings.iter().map(|warning| (warning.name(), in_words(&text(warning)))).collect()
    }

    pub(super) fn against(&self) -> Position {
        self.file.measured.table.against()
    }

    pub(super) fn unit(&self) -> &'static str {
        self.file.measured.unit
    }

    pub(super) fn weighting(&self) -> &'static str {
        let table = &self.file.measured.table;
        match (table.is_weighted(), table.unstated_errors()) {
            (true, _) => "stated uncertainties",
            (false, UnstatedErrors::Absolute) => {
                "none stated: equal absolute errors of all amplitudes, from their scatter"
            }
            (false, UnstatedErrors::Relative) => {
                "none stated: equal relative errors of all amplitudes, from their scatter"
            }
        }
    }

    pub(super) fn coefficients(&self) -> Vec<LawCoefficient> {
        let described = |of: &DampingCoefficient| LawCoefficient {
            of: *of,
            unit: units(of.term, self.unit(), ["/s^2", "1/s", "1/"]),
            rate_unit: match self.against() {
                Position::Time => units(of.term, self.unit(), ["/s", "1/s", "1/s/"]),
                Position::Swings => units(of.term, self.unit(), ["", "1", "1/"]),
            },
        };
        self.fit.coefficients.iter().map(described).collect()
    }

    pub(super) fn quality(&self) -> Result<Quality, String> {
        self.fit.quality.ok_or_else(no_period)
    }

    fn last_quality(&self) -> Result<Quality, String> {
        match self.fit.last_quality {
            Some(quality) => Ok(quality),
            None if self.fit.quality.is_none() => Err(no_period()),
            None => Err("linear damping has the same at every amplitude".to_owned()),
        }
    }

    fn log_decrement(&self) -> Result<Uncertain, String> {
        let reason = "the decrement depends on the amplitude";
        self.quality()?.log_decrement().ok_or_else(|| reason.to_owned())
    }

    fn zero(&self) -> Result<Uncertain, String> {
        self.fit.law().zero.ok_or_else(|| ONE_SIDE.to_owned())
    }

    /// The decay in seconds.
    fn decay_time(&self) -> Result<Uncertain, String> {
        match (self.against(), self.fit.period) {
            (Position::Time, _) => Ok(self.fit.decay),
            (Position::Swings, Some(period)) => Ok(product(self.fit.decay, period)),
            (Position::Swings, None) => Err(no_period()),
        }
    }

    fn decay_swings(&self) -> Result<f64, String> {
        match (self.against(), self.fit.period) {
            (Position::Swings, _) => Ok(self.fit.decay.value),
            (Position::Time, Some(period)) => Ok(self.fit.decay.value / period.value),
            (Position::Time, None) => Err(no_period()),
        }
    }

    fn measurements(&self) -> Vec<PredictedRow> {
        let (table, law) = (&self.file.measured.table, self.fit.law());
        let rows = table.positions().zip(table.values()).zip(&law.residuals);
        let row = |((position, value), &residual): ((f64, f64), &f64)| PredictedRow {
            position,
            value,
            fitted: value - residual,
            residual,
        };
        rows.map(row).collect()
    }
}

/// The units of dry, linear and quadratic damping with the unit of the amplitude in them.
fn units(term: DampingKind, unit: &str, [dry, linear, quadratic]: [&str; 3]) -> String {
    match term {
        DampingKind::Dry => format!("{unit}{dry}"),
        DampingKind::Linear => linear.to_owned(),
        DampingKind::Quadratic => format!("{quadratic}{unit}"),
    }
}

fn product(one: Uncertain, other: Uncertain) -> Uncertain {
    let value = one.value * other.value;
    let relative = (one.relative() * one.relative() + other.relative() * other.relative()).sqrt();
    Uncertain { value, uncertainty: value * relative }
}

pub(super) fn of_answer<'a>() -> Fields<FitAmplitudesResult<'a>> {
    before_the_result().and(of_result()).and(of_quality()).and(of_rows()).and(warnings::fields(
        |result: &FitAmplitudesResult<'a>| warnings::texts(result.warnings()),
        |result| warnings::names(result.warnings()),
    ))
}

fn before_the_result<'a>() -> Fields<FitAmplitudesResult<'a>> {
    type Of<'a> = Field<FitAmplitudesResult<'a>>;
    Fields::from([
        Of::value("rows", "1", "rows that were fitted", |result| result.file.measured.table.len().into()),
        Of::value("rows_incomplete", "1", "rows left out because a number is missing", |result| {
            result.file.dropped.into()
        }),
        Of::value("told_from_file[]", "", "settings inferred from the file", |result| {
            json::list(result.file.inferences.sentences.clone())
        }),
        Of::nested("read_columns[].", &of_columns(), |result| {
            of_columns().records(&result.file.inferences.columns)
        }),
        Of::value("weighting", "", "weights of the rows", |result| result.weighting().into()),
        Of::value("amplitude_unit", "", "rad, m or counts: the unit of the fitted amplitudes", |result| {
            result.unit().into()
        }),
        Of::value("against", "", "time or swings: the quantity of the positions", |result| {
            match result.against() {
                Position::Time => "time",
                Position::Swings => "swings",
            }
            .into()
        }),
        Of::value("sides", "", "one for amplitudes, both for turning points", |result| {
            match result.file.measured.table.sides() {
                Sides::One => "one",
                Sides::Both => "both",
            }
            .into()
        }),
    ])
}

fn of_result<'a>() -> Fields<FitAmplitudesResult<'a>> {
    type Of<'a> = Field<FitAmplitudesResult<'a>>;
    Fields::from([
        Of::value("law", "", "damping of the reported result", |result| {
            result.fit.law().damping.to_string().into()
        }),
        Of::number("first_amplitude", "", "fitted amplitude at the first row", |result| {
            result.fit.law().first_amplitude.value
        }),
        Of::number("first_amplitude_uncertainty", "", "standard uncertainty of that", |result| {
            result.fit.law().first_amplitude.uncertainty
        }),
        Of::known("zero", "", "reading of the scale at the equilibrium, in its SI unit, or null", |result| {
            result.zero().map(|zero| zero.value)
        }),
        Of::known("zero_uncertainty", "", "standard uncertainty of that, or null", |result| {
            result.zero().map(|zero| zero.uncertainty)
        }),
        Of::nested("coefficients[].", &of_coefficient(), |result| {
            of_coefficient().records(&result.coefficients())
        }),
        Of::known(
            "small_angle_period_s",
            "s",
            "period T₀ of small swings with the damping, or null",
            |result| result.fit.period.map(|period| period.value).ok_or_else(no_period),
        ),
        Of::known(
            "small_angle_period_uncertainty_s",
            "s",
            "standard uncertainty of T₀, or null",
            |result| result.fit.period.map(|period| period.uncertainty).ok_or_else(no_period),
        ),
        Of::known("omega0_rad_per_s", "rad/s", "ω0 of small swings without damping, or null", |result| {
            result.fit.natural_frequency.map(|omega0| omega0.value).ok_or_else(no_period)
        }),
        Of::known("omega0_uncertainty_rad_per_s", "rad/s", "standard uncertainty of ω0, or null", |result| {
            result.fit.natural_frequency.map(|omega0| omega0.uncertainty).ok_or_else(no_period)
        }),
    ])
}

/// Q, the logarithmic decrement, the time of decay.
fn of_quality<'a>() -> Fields<FitAmplitudesResult<'a>> {
    type Of<'a> = Field<FitAmplitudesResult<'a>>;
    Fields::from([
        Of::known("quality", "1", QUALITY, |result| result.quality().map(|quality| quality.factor.value)),
        Of::known("quality_uncertainty", "1", "standard uncertainty of Q, or null", |result| {
            result.quality().map(|quality| quality.factor.uncertainty)
        }),
        Of::known("quality_amplitude", "", "amplitude of the cycle that Q describes, or null", |result| {
            let reason = || "Q of linear damping is the same at every amplitude".to_owned();
            result.quality()?.amplitude.ok_or_else(reason)
        }),
        Of::known(
            "last_quality",
            "1",
            "Q at the last row, of other than linear damping, or null",
            |result| result.last_quality().map(|quality| quality.factor.value),
        ),
        Of::known("last_quality_uncertainty", "1", "standard uncertainty of that, or null", |result| {
            result.last_quality().map(|quality| quality.factor.uncertainty)
        }),
        Of::known("last_quality_amplitude", "", "amplitude at the last row, or null", |result| {
            result.last_quality()?.amplitude.ok_or_else(|| "linear damping".to_owned())
        }),
        Of::known("log_decrement", "1", "π/√(Q² − 1/4) of linear damping, or null", |result| {
            result.log_decrement().map(|decrement| decrement.value)
        }),
        Of::known("log_decrement_uncertainty", "1", "standard uncertainty of that, or null", |result| {
            result.log_decrement().map(|decrement| decrement.uncertainty)
        }),
        Of::known(
            "decay_time_s",
            "s",
            "time of a fall by e at the rate at the first row, or null",
            |result| result.decay_time().map(|time| time.value),
        ),
        Of::known("decay_time_uncertainty_s", "s", "standard uncertainty of that, or null", |result| {
            result.decay_time().map(|time| time.uncertainty)
        }),
        Of::known(
            "decay_swings",
            "1",
            "the same as a number of swings, or null",
            FitAmplitudesResult::decay_swings,
        ),
    ])
}

fn of_rows<'a>() -> Fields<FitAmplitudesResult<'a>> {
    type Of<'a> = Field<FitAmplitudesResult<'a>>;
    Fields::from([
        Of::nested("laws[].", &of_law(), |result| of_law().records(&result.fit.laws)),
        Of::nested("measurements[].", &of_measurement(), |result| {
            of_measurement().records(&result.measurements())
        }),
    ])
}

const QUALITY: &str = "ω0/c of linear damping, 2πE/ΔE at the first row of any other, or null";

fn of_coefficient() -> Fields<LawCoefficient> {
    type Of = Field<LawCoefficient>;
    Fields::from([
        Of::value("damping", "", "dry, linear or quadratic", |coefficient| coefficient.of.term.name().into()),
        Of::known(
            "coefficient",
            "",
            "c of the acceleration −c·θ′|θ′|ⁿ⁻¹, n = 0, 1 or 2, or null",
            |law| law.of.coefficient.map(|coefficient| coefficient.value).ok_or_else(no_period),
        ),
        Of::known("coefficient_uncertainty", "", "standard uncertainty of c, or null", |law| {
            law.of.coefficient.map(|coefficient| coefficient.uncertainty).ok_or_else(no_period)
        }),
        Of::value("unit", "", "unit of c", |coefficient| coefficient.unit.clone().into()),
        Of::number(
            "rate",
            "",
            "c·ω0ⁿ⁻¹, by which the amplitude falls per second or swing",
            |coefficient| coefficient.of.rate.value,
        ),
        Of::number("rate_uncertainty", "", "standard uncertainty of that", |coefficient| {
            coefficient.of.rate.uncertainty
        }),
        Of::value("rate_unit", "", "unit of the rate", |coefficient| coefficient.rate_unit.clone().into()),
    ])
}

const COLUMNS: [&str; 7] = ["law", "Q", "±", "amplitude", "χ²/dof", "ΔAICc", "by chance"];

pub(super) fn of_law() -> Fields<LawOfAmplitudes> {
    type Of = Field<LawOfAmplitudes>;
    Fields::from([
        Of::value("law", "", "kinds of damping", |law| law.damping.to_string().into())
            .words(COLUMNS[0], |law| law.damping.to_string()),
        Of::known("quality", "1", QUALITY, |law| {
            law.quality.map(|quality| quality.factor.value).ok_or_else(no_period)
        })
        .numeral(COLUMNS[1], |law| law.quality.map_or("–".to_owned(), |quality| value(quality.factor))),
        Of::known("quality_uncertainty", "1", "standard uncertainty of Q under this law, or null", |law| {
            law.quality.map(|quality| quality.factor.uncertainty).ok_or_else(no_period)
        })
        .numeral(COLUMNS[2], |law| or_dash(law.quality.map(|quality| quality.factor.uncertainty), 2)),
        Of::known("quality_amplitude", "", "amplitude of the cycle that Q describes, or null", |law| {
            law.quality
                .and_then(|quality| quality.amplitude)
                .ok_or_else(|| "linear damping, or no period".to_owned())
        })
        .only_json(),
        Of::number("first_amplitude", "", "fitted amplitude at the first row", |law| {
            law.first_amplitude.value
        })
        .numeral(COLUMNS[3], |law| value(law.first_amplitude)),
        Of::number("first_amplitude_uncertainty", "", "standard uncertainty of that", |law| {
            law.first_amplitude.uncertainty
        })
        .only_json(),
        Of::known("chi2_per_dof", "1", "χ² per degree of freedom, or null", |law| {
            law.scatter()
                .map(|scatter| scatter.chi2_per_dof())
                .ok_or_else(|| "no uncertainties are stated, or there are too few rows".to_owned())
        })
        .rounded(COLUMNS[4], 4)
        .or("–"),
        Of::value("dof", "1", "degrees of freedom", |law| law.dof.into()).only_json(),
        Of::known("aicc", "1", "Akaike's criterion, corrected for few rows, or null", |law| {
            law.aicc.ok_or_else(|| "too few rows".to_owned())
        })
        .only_json(),
        Of::number("aicc_difference", "1", "excess of the criterion over the least one", |law| {
            law.aicc_difference
        })
        .numeral(COLUMNS[5], |law| number::rounded(law.aicc_difference, 3)),
        Of::known(
            "chance_of_last_parameter",
            "1",
            "probability of an improvement over the best simpler law as large by chance, or null",
            |law| law.chance.ok_or_else(|| "too few rows".to_owned()),
        )
        .numeral(COLUMNS[6], |law| match law.chance {
            Some(chance) if chance < 1e-15 => "<1e-15".to_owned(),
            chance => or_dash(chance, 2),
        }),
        Of::number(
            "rows_per_error",
            "1",
            "neighbouring rows that share one error, 1 for white noise",
            |law| law.rows_per_error,
        )
        .only_json(),
        scatter::birge_ratio_field(|law: &LawOfAmplitudes| scatter::birge_ratio(law.scatter())),
        scatter::enlargement_field(|law: &LawOfAmplitudes| Some(scatter::enlargement(law.scatter()))),
    ])
}

fn of_measurement() -> Fields<PredictedRow> {
    type Of = Field<PredictedRow>;
    Fields::from([
        Of::number("position", "", "time in seconds, or number of swings", |row| row.position),
        Of::number("value", "", "amplitude or turning point, in its SI unit", |row| row.value),
        Of::number("fitted", "", "value under the law", |row| row.fitted),
        Of::number("residual", "", "value less the fitted one", |row| row.residual),
    ])
}

/// A value with two digits of its uncertainty.
fn value(estimate: Uncertain) -> String {
    let text = estimate.to_string();
    text.split(" ±").next().unwrap_or_default().to_owned()
}

fn or_dash(value: Option<f64>, digits: usize) -> String {
    value.filter(|value| !value.is_nan()).map_or("–".to_owned(), |value| number::rounded(value, digits))
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = of_answer().described("");
    vec![Answers { command: "fit amplitudes", option: "", json, csv: of_law().described_in_csv() }]
}
