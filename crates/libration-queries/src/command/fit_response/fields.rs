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
        Of::value("rows", "1", "rows that were fitted", |it| it.file.measured.table.len().into()),
        Of::value("rows_incomplete", "1", "rows left out because a number is missing", |it| {
            it.file.dropped.into()
        }),
        Of::value("told_from_file[]", "", "settings inferred from the file", |it| {
            json::list(it.file.inferences.sentences.clone())
        }),
        Of::nested("read_columns[].", &of_columns(), |it| of_columns().records(&it.file.inferences.columns)),
        Of::value("weighting", "", "weights of the rows", |it| it.weighting().into()),
        Of::value("amplitude_unit", "", "rad, m or counts: the unit of all amplitudes here", |it| {
            it.file.unit.into()
        }),
        Of::value(
            "phases_lead",
            "",
            "true if the phases of the file are leads of the response over the drive",
            |it| it.file.measured.table.leads().into(),
        ),
        Of::value("preferred", "", "the simplest model consistent with the rows", |it| {
            it.fit.best().model.name().into()
        }),
        Of::nested("parameters[].", &of_parameter(), |it| of_parameter().records(&it.parameters())),
        Of::nested("models[].", &of_model(), |it| of_model().records(&it.fit.fits)),
        Of::value("left_out[]", "", "reasons why other models could not be fitted", |it| {
            json::list(it.fit.left_out.iter().map(ToString::to_string))
        }),
        Of::nested("jumps[].", &of_jump(), |it| of_jump().records(&it.curve.jumps)),
        Of::nested("measurements[].", &of_measurement(), |it| of_measurement().records(&it.measurements())),
        Of::nested("curve[].", &of_curve(), |it| of_curve().records(&it.on_curve())),
    ]);
    before.and(warnings::fields(
        |it: &FitResponseResult<'a>| warnings::texts(it.warnings()),
        |it| warnings::names(it.warnings()),
    ))
}

const COLUMNS: [&str; 10] = ["model", "ω0 / (rad/s)", "±", "c / (1/s)", "±", "A", "±", "κ", "χ²/dof", "AICc"];

pub(super) fn of_model() -> Fields<ResponseFit> {
    type Of = Field<ResponseFit>;
    Fields::from([
        Of::value("model", "", "linear, pendulum or duffing", |it| it.model.name().into())
            .words(COLUMNS[0], |it| it.model.name().to_owned()),
        Of::number("omega0_rad_per_s", "rad/s", "frequency ω0 of small free oscillations", |it| {
            it.natural_frequency.value
        })
        .numeral(COLUMNS[1], |it| value(it.natural_frequency)),
        Of::number("omega0_uncertainty_rad_per_s", "rad/s", "standard uncertainty of ω0", |it| {
            it.natural_frequency.uncertainty
        })
        .numeral(COLUMNS[2], |it| number::rounded(it.natural_frequency.uncertainty, 2)),
        Of::number("damping_per_s", "1/s", "c of the acceleration −c·x′", |it| it.damping.value)
            .numeral(COLUMNS[3], |it| value(it.damping)),
        Of::number("damping_uncertainty_per_s", "1/s", "standard uncertainty of c", |it| {
            it.damping.uncertainty
        })
        .numeral(COLUMNS[4], |it| number::rounded(it.damping.uncertainty, 2)),
        Of::number("drive", "", "A, the driving acceleration in the unit of the amplitude over s²", |it| {
            it.drive.value
        })
        .numeral(COLUMNS[5], |it| value(it.drive)),
        Of::number("drive_uncertainty", "", "standard uncertainty of A", |it| it.drive.uncertainty)
            .numeral(COLUMNS[6], |it| number::rounded(it.drive.uncertainty, 2)),
        Of::known("cubic", "", CUBIC, |it| it.cubic.map(|cubic| cubic.value).ok_or_else(not_free))
            .numeral(COLUMNS[7], |it| it.cubic.map_or("–".to_owned(), value)),
        Of::known("cubic_uncertainty", "", "standard uncertainty of κ, or null", |it| {
            it.cubic.map(|cubic| cubic.uncertainty).ok_or_else(not_free)
        }),
        Of::number("quality", "1", "ω0/c", |it| it.quality().value),
        Of::number("quality_uncertainty", "1", "standard uncertainty of ω0/c", |it| {
            it.quality().uncertainty
        }),
        Of::value("covariance[][]", "", "of ω0, c, perhaps κ, and A, in their units", covariance).only_json(),
        Of::known("chi2_per_dof", "1", "χ² per degree of freedom, or null", |it| {
            it.chi2_per_dof()
                .ok_or_else(|| "no uncertainties are stated, or there are too few rows".to_owned())
        })
        .rounded(COLUMNS[8], 4)
        .or("–"),
        Of::value("dof", "1", "degrees of freedom", |it| it.dof.into()).only_json(),
        Of::known(
            "amplitude_scatter",
            "",
            "standard deviation of the amplitudes by their scatter, over the amplitude with relative errors, or null",
            |it| it.amplitude_scatter.ok_or_else(|| "uncertainties are stated".to_owned()),
        )
        .only_json(),
        Of::known("aicc", "1", "Akaike's criterion, corrected for few rows, or null", |it| {
            it.aicc.ok_or_else(|| "too few rows".to_owned())
        })
        .rounded(COLUMNS[9], 5)
        .or("–"),
        scatter::birge_ratio_field(|it: &ResponseFit| scatter::birge_ratio(it.scatter())),
        scatter::enlargement_field(|it: &ResponseFit| Some(scatter::enlargement(it.scatter()))),
    ])
}

const CUBIC: &str = "κ of the acceleration −κ·x³, in 1/s² over the amplitude's unit squared, or null";

fn covariance(fit: &ResponseFit) -> Value {
    json::list(fit.covariance.iter().map(|row| json::list(row.iter().map(|&it| json::number(it)))))
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
        Of::value("name", "", "omega0, c, kappa or A, of the preferred model", |it| it.name.into()),
        Of::number("value", "", "in its unit", |it| it.estimate.value),
        Of::number("uncertainty", "", "standard uncertainty, in the same unit", |it| it.estimate.uncertainty),
        Of::value("unit", "", "unit of the parameter", |it| it.unit.clone().into()),
    ])
}

fn of_curve() -> Fields<OnCurve> {
    type Of = Field<OnCurve>;
    Fields::from([
        Of::value("branch", "1", "number of the branch, from 1", |it| it.branch.into()),
        Of::number("angular_frequency_rad_per_s", "rad/s", "frequency of the drive", |it| it.point.frequency),
        Of::number("amplitude", "", "as measured", |it| it.point.amplitude),
        Of::number("phase_rad", "rad", "phase lag of the response behind the drive", |it| it.point.phase),
        Of::value("stability", "", "attracting, neutral, unstable or undetermined", |it| {
            it.point.stability.name().into()
        }),
    ])
}

pub(super) fn of_jump() -> Fields<FittedJump> {
    type Of = Field<FittedJump>;
    Fields::from([
        Of::value("rising", "", "true if it occurs at rising frequency", |it| it.rising.into()),
        Of::number("angular_frequency_rad_per_s", "rad/s", "frequency at which a slow sweep jumps", |it| {
            it.frequency.value
        }),
        Of::number(
            "angular_frequency_uncertainty_rad_per_s",
            "rad/s",
            "standard uncertainty of that",
            |it| it.frequency.uncertainty,
        ),
        Of::number("amplitude", "", "the largest displacement before the jump", |it| it.amplitude),
        Of::known("to_amplitude", "", "the largest displacement after the jump, or null", |it| {
            it.to_amplitude
                .ok_or_else(|| "there is no stable response with the period of the drive".to_owned())
        }),
    ])
}

pub(super) fn of_measurement<'a>() -> Fields<FittedRow<'a>> {
    type Of<'a> = Field<FittedRow<'a>>;
    Fields::from([
        Of::number("angular_frequency_rad_per_s", "rad/s", "the frequency that was measured", |it| {
            it.frequency
        }),
        Of::number("amplitude", "", "the amplitude that was measured", |it| it.amplitude),
        Of::number("fitted_amplitude", "", "fitted amplitude on the same branch", |it| it.fitted.amplitude),
        Of::number("residual", "1", "residual, in standard deviations", |it| it.fitted.residual),
        Of::value(
            "stability",
            "",
            "stability of this response: attracting, neutral, unstable or undetermined",
            |it| it.fitted.stability.name().into(),
        ),
        Of::value("between_folds", "", "true if it is certain to lie where no response is stable", |it| {
            it.fitted.between_folds.into()
        }),
        Of::nullable(
            "beyond_fold_rad_per_s",
            "rad/s",
            "least distance beyond the end of its branch, or null",
            |it| it.fitted.beyond_fold,
        ),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = of_answer().described("");
    vec![Answers { command: "fit response", option: "", json, csv: of_model().described_in_csv() }]
}
