//! Fields of a response, of each model, of each row and of each jump.

use super::input::ResponseFile;
use crate::arguments::of_columns;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::warnings::{self, NamedWarning};
use crate::output::{json, number, scatter};
use libration_lab::fit::Uncertain;
use libration_lab::fit::response::{
    AmplitudeErrors, FittedAnswer, FittedCurve, FittedCurvePoint, FittedJump, ResponseFit, ResponsesFit,
};
use serde_json::Value;

/// The result for the measurements.
pub(super) struct FitResponseResult<'a> {
    pub(super) file: &'a ResponseFile,
    pub(super) fit: &'a ResponsesFit,
    pub(super) curve: &'a FittedCurve,
}

/// A parameter of the preferred model.
pub(super) struct FittedParameter {
    name: &'static str,
    estimate: Uncertain,
    unit: String,
}

/// A response on the curve, with the number of its branch from 1.
pub(super) struct OnCurve {
    branch: usize,
    point: FittedCurvePoint,
}

/// A row with its fitted values.
pub(super) struct FittedRow<'a> {
    pub(super) frequency: f64,
    pub(super) amplitude: f64,
    pub(super) fitted: &'a FittedAnswer,
}

impl FitResponseResult<'_> {
    pub(super) fn warnings(&self) -> Vec<NamedWarning> {
        self.fit.warnings.iter().map(|warning| (warning.name(), warning.to_string())).collect()
    }

    pub(super) fn weighting(&self) -> &'static str {
        match self.file.measured.table.amplitude_errors() {
            AmplitudeErrors::Stated => "stated uncertainties",
            AmplitudeErrors::Absolute => {
                "none stated: equal absolute errors of all amplitudes, from their scatter"
            }
            AmplitudeErrors::Relative => {
                "none stated: equal relative errors of all amplitudes, from their scatter"
            }
        }
    }

    /// The parameters in the order of the covariance.
    fn parameters(&self) -> Vec<FittedParameter> {
        let (best, unit) = (self.fit.best(), self.file.unit);
        let parameter =
            |name, estimate, unit: &str| FittedParameter { name, estimate, unit: unit.to_owned() };
        let cubic = best.cubic.map(|cubic| parameter("kappa", cubic, &format!("1/(s^2 {unit}^2)")));
        [parameter("omega0", best.natural_frequency, "rad/s"), parameter("c", best.damping, "1/s")]
            .into_iter()
            .chain(cubic)
            .chain([parameter("A", best.drive, &format!("{unit}/s^2"))])
            .collect()
    }

    fn on_curve(&self) -> Vec<OnCurve> {
        let branches = (1..).zip(&self.curve.branches);
        branches
            .flat_map(|(branch, points)| points.iter().map(move |&point| OnCurve { branch, point }))
            .collect()
    }

    pub(super) fn measurements(&self) -> Vec<FittedRow<'_>> {
        let measured = &self.file.measured;
        let rows = measured.frequencies.iter().zip(&measured.amplitudes).zip(&self.fit.best().rows);
        rows.map(|((&frequency, &amplitude), fitted)| FittedRow { frequency, amplitude, fitted }).collect()
    }
}

pub(super) fn of_answer<'a>() -> Fields<FitResponseResult<'a>> {
    type Of<'a> = Field<FitResponseResult<'a>>;
    let before = Fields::from([
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
        Of::value("amplitude_unit", "", "rad, m or counts: the unit of all amplitudes here", |result| {
            result.file.unit.into()
        }),
        Of::value(
            "phases_lead",
            "",
            "true if the phases of the file are leads of the response over the drive",
            |result| result.file.measured.table.leads().into(),
        ),
        Of::value("preferred", "", "the simplest model consistent with the rows", |result| {
            result.fit.best().model.name().into()
        }),
        Of::nested("parameters[].", &of_parameter(), |result| of_parameter().records(&result.parameters())),
        Of::nested("models[].", &of_model(), |result| of_model().records(&result.fit.fits)),
        Of::value("left_out[]", "", "reasons why other models could not be fitted", |result| {
            json::list(result.fit.left_out.iter().map(ToString::to_string))
        }),
        Of::nested("jumps[].", &of_jump(), |result| of_jump().records(&result.curve.jumps)),
        Of::nested("measurements[].", &of_measurement(), |result| {
            of_measurement().records(&result.measurements())
        }),
        Of::nested("curve[].", &of_curve(), |result| of_curve().records(&result.on_curve())),
    ]);
    before.and(warnings::fields(
        |result: &FitResponseResult<'a>| warnings::texts(result.warnings()),
        |result| warnings::names(result.warnings()),
    ))
}

const COLUMNS: [&str; 10] = ["model", "ω0 / (rad/s)", "±", "c / (1/s)", "±", "A", "±", "κ", "χ²/dof", "AICc"];

pub(super) fn of_model() -> Fields<ResponseFit> {
    type Of = Field<ResponseFit>;
    Fields::from([
        Of::value("model", "", "linear, pendulum or duffing", |fit| fit.model.name().into())
            .words(COLUMNS[0], |fit| fit.model.name().to_owned()),
        Of::number("omega0_rad_per_s", "rad/s", "frequency ω0 of small free oscillations", |fit| {
            fit.natural_frequency.value
        })
        .numeral(COLUMNS[1], |fit| value(fit.natural_frequency)),
        Of::number("omega0_uncertainty_rad_per_s", "rad/s", "standard uncertainty of ω0", |fit| {
            fit.natural_frequency.uncertainty
        })
        .numeral(COLUMNS[2], |fit| number::rounded(fit.natural_frequency.uncertainty, 2)),
        Of::number("damping_per_s", "1/s", "c of the acceleration −c·x′", |fit| fit.damping.value)
            .numeral(COLUMNS[3], |fit| value(fit.damping)),
        Of::number("damping_uncertainty_per_s", "1/s", "standard uncertainty of c", |fit| {
            fit.damping.uncertainty
        })
        .numeral(COLUMNS[4], |fit| number::rounded(fit.damping.uncertainty, 2)),
        Of::number("drive", "", "A, the driving acceleration in the unit of the amplitude over s²", |fit| {
            fit.drive.value
        })
        .numeral(COLUMNS[5], |fit| value(fit.drive)),
        Of::number("drive_uncertainty", "", "standard uncertainty of A", |fit| fit.drive.uncertainty)
            .numeral(COLUMNS[6], |fit| number::rounded(fit.drive.uncertainty, 2)),
        Of::known("cubic", "", CUBIC, |fit| fit.cubic.map(|cubic| cubic.value).ok_or_else(not_free))
            .numeral(COLUMNS[7], |fit| fit.cubic.map_or("–".to_owned(), value)),
        Of::known("cubic_uncertainty", "", "standard uncertainty of κ, or null", |fit| {
            fit.cubic.map(|cubic| cubic.uncertainty).ok_or_else(not_free)
        }),
        Of::number("quality", "1", "ω0/c", |fit| fit.quality().value),
        Of::number("quality_uncertainty", "1", "standard uncertainty of ω0/c", |fit| {
            fit.quality().uncertainty
        }),
        Of::value("covariance[][]", "", "of ω0, c, perhaps κ, and A, in their units", covariance).only_json(),
        Of::known("chi2_per_dof", "1", "χ² per degree of freedom, or null", |fit| {
            fit.chi2_per_dof()
                .ok_or_else(|| "no uncertainties are stated, or there are too few rows".to_owned())
        })
        .rounded(COLUMNS[8], 4)
        .or("–"),
        Of::value("dof", "1", "degrees of freedom", |fit| fit.dof.into()).only_json(),
        Of::known(
            "amplitude_scatter",
            "",
            "standard deviation of the amplitudes by their scatter, over the amplitude with relative errors, or null",
            |fit| fit.amplitude_scatter.ok_or_else(|| "uncertainties are stated".to_owned()),
        )
        .only_json(),
        Of::known("aicc", "1", "Akaike's criterion, corrected for few rows, or null", |fit| {
            fit.aicc.ok_or_else(|| "too few rows".to_owned())
        })
        .rounded(COLUMNS[9], 5)
        .or("–"),
        scatter::birge_ratio_field(|fit: &ResponseFit| scatter::birge_ratio(fit.scatter())),
        scatter::enlargement_field(|fit: &ResponseFit| Some(scatter::enlargement(fit.scatter()))),
    ])
}

const CUBIC: &str = "κ of the acceleration −κ·x³, in 1/s² over the amplitude's unit squared, or null";

fn covariance(fit: &ResponseFit) -> Value {
    json::list(fit.covariance.iter().map(|row| json::list(row.iter().map(|&entry| json::number(entry)))))
}

fn not_free() -> String {
    "not free in this model".to_owned()
}

/// A value with two digits of its uncertainty.
fn value(estimate: Uncertain) -> String {
    let text = estimate.to_string();
    text.split(" ±").next().unwrap_or_default().to_owned()
}

fn of_parameter() -> Fields<FittedParameter> {
    type Of = Field<FittedParameter>;
    Fields::from([
        Of::value("name", "", "omega0, c, kappa or A, of the preferred model", |parameter| {
            parameter.name.into()
        }),
        Of::number("value", "", "in its unit", |parameter| parameter.estimate.value),
        Of::number("uncertainty", "", "standard uncertainty, in the same unit", |parameter| {
            parameter.estimate.uncertainty
        }),
        Of::value("unit", "", "unit of the parameter", |parameter| parameter.unit.clone().into()),
    ])
}

fn of_curve() -> Fields<OnCurve> {
    type Of = Field<OnCurve>;
    Fields::from([
        Of::value("branch", "1", "number of the branch, from 1", |curve| curve.branch.into()),
        Of::number("angular_frequency_rad_per_s", "rad/s", "frequency of the drive", |curve| {
            curve.point.frequency
        }),
        Of::number("amplitude", "", "as measured", |curve| curve.point.amplitude),
        Of::number("phase_rad", "rad", "phase lag of the response behind the drive", |curve| {
            curve.point.phase
        }),
        Of::value("stability", "", "attracting, neutral, unstable or undetermined", |curve| {
            curve.point.stability.name().into()
        }),
    ])
}

pub(super) fn of_jump() -> Fields<FittedJump> {
    type Of = Field<FittedJump>;
    Fields::from([
        Of::value("rising", "", "true if it occurs at rising frequency", |jump| jump.rising.into()),
        Of::number("angular_frequency_rad_per_s", "rad/s", "frequency at which a slow sweep jumps", |jump| {
            jump.frequency.value
        }),
        Of::number(
            "angular_frequency_uncertainty_rad_per_s",
            "rad/s",
            "standard uncertainty of that",
            |jump| jump.frequency.uncertainty,
        ),
        Of::number("amplitude", "", "the largest displacement before the jump", |jump| jump.amplitude),
        Of::known("to_amplitude", "", "the largest displacement after the jump, or null", |jump| {
            jump.to_amplitude
                .ok_or_else(|| "there is no stable response with the period of the drive".to_owned())
        }),
    ])
}

pub(super) fn of_measurement<'a>() -> Fields<FittedRow<'a>> {
    type Of<'a> = Field<FittedRow<'a>>;
    Fields::from([
        Of::number("angular_frequency_rad_per_s", "rad/s", "the frequency that was measured", |row| {
            row.frequency
        }),
        Of::number("amplitude", "", "the amplitude that was measured", |row| row.amplitude),
        Of::number("fitted_amplitude", "", "fitted amplitude on the same branch", |row| row.fitted.amplitude),
        Of::number("residual", "1", "residual, in standard deviations", |row| row.fitted.residual),
        Of::value(
            "stability",
            "",
            "stability of this response: attracting, neutral, unstable or undetermined",
            |row| row.fitted.stability.name().into(),
        ),
        Of::value("between_folds", "", "true if it is certain to lie where no response is stable", |row| {
            row.fitted.between_folds.into()
        }),
        Of::nullable(
            "beyond_fold_rad_per_s",
            "rad/s",
            "least distance beyond the end of its branch, or null",
            |row| row.fitted.beyond_fold,
        ),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = of_answer().described("");
    vec![Answers { command: "fit response", option: "", json, csv: of_model().described_in_csv() }]
}
