//! Fields of measured swings, of their rows, cycles and traces, and of the models that were compared.

mod cycle;
mod model;
mod parameter;
mod trace;

use super::answer::FitTraceResult;
use super::input::File;
use crate::call::in_words;
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::{budget, normal_gravity, warnings};
use libration::quantity::Quantity;
use libration_lab::fit::swings::{Advice, FittedPendulum, Warning};
use libration_lab::fit::{Budget, Quality, Uncertain};
use libration_lab::measurement::Observable;
use serde_json::Value;

pub(super) use cycle::{COLUMNS as CYCLE_COLUMNS, cycles, of_cycle};
pub(super) use model::{DampingModel, coefficients, models, of_model, shown as shown_models};
pub(super) use parameter::{of_parameter, rows as parameters, shown as shown_parameters};
pub(super) use trace::{of_row, of_trace, rows, traces};

/// The whole result.
pub(super) fn record(answer: &FitTraceResult<'_>) -> Record {
    let record = of_fit().record(answer);
    let record = normal_gravity::fields().added_to(record, &answer.normal);
    let record = match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, length } => {
            of_gravity().added_to(budget::added_to(record, budget), &(budget, *length))
        }
        FittedPendulum::Length(length) => of_length().added_to(record, length),
    };
    of_doubts().added_to(record, answer)
}

/// The fields that precede those of the pendulum.
fn of_fit<'a>() -> Fields<FitTraceResult<'a>> {
    type Of<'a> = Field<FitTraceResult<'a>>;
    Fields::from([
        Of::value("files[]", "", "names of the files", |result| {
            json::list(result.measured.files.iter().map(|file| file.name.as_str()))
        }),
        Of::value("model", "", "damping that was fitted", |result| {
            result.swings.fit.damping.to_string().into()
        }),
        Of::nested("parameters[].", &of_parameter().and([parameter::trace()]), |result| {
            of_parameter().and([parameter::trace()]).records(&parameters(result))
        }),
        Of::known(
            "chi2_per_dof",
            "1",
            "χ² per degree of freedom, or null without uncertainties of the rows",
            |result| {
                result.swings.fit.chi2_per_dof.ok_or_else(|| "the rows have no uncertainties".to_owned())
            },
        ),
        Of::present(
            "rms_residual_rad",
            "rad",
            "root mean square of the residuals, where angles were measured",
            |result| rms(result, Observable::Angle),
        ),
        Of::present(
            "rms_residual_rad_per_s",
            "rad/s",
            "the same where angular velocities were measured",
            |result| rms(result, Observable::AngularVelocity),
        ),
        Of::value("rows", "1", "rows that were fitted", |result| result.swings.fit.rows().into()),
        Of::value("converged", "", "true if the fit converged to the least sum of squares", |result| {
            result.swings.fit.converged.into()
        }),
        Of::number("small_angle_period_s", "s", "period of small swings T₀", |result| {
            result.swings.small_angle_period().value
        }),
        Of::number("small_angle_period_uncertainty_s", "s", "standard uncertainty of T₀", |result| {
            result.swings.small_angle_period().uncertainty
        }),
        Of::known("quality", "1", QUALITY, |result| quality(result).map(|quality| quality.factor.value)),
        Of::known("quality_uncertainty", "1", "standard uncertainty of Q, or null", |result| {
            quality(result).map(|quality| quality.factor.uncertainty)
        }),
        Of::known(
            "quality_amplitude_rad",
            "rad",
            "amplitude of the cycle that Q describes, or null",
            |result| {
                let reason = || "Q of linear damping is the same at every amplitude".to_owned();
                quality(result)?.amplitude.ok_or_else(reason)
            },
        ),
        Of::nested("cycles[].", &of_cycle(), |result| of_cycle().records(&cycles(result))),
        Of::known(
            "beta",
            "1",
            "measured rise of the period with the amplitude over that of the exact law, or null",
            |result| result.swings.beta.as_ref().map(|beta| beta.factor.value).map_err(ToString::to_string),
        ),
        Of::known("beta_uncertainty", "1", "standard uncertainty of β, or null", |result| {
            result.swings.beta.as_ref().map(|beta| beta.factor.uncertainty).map_err(ToString::to_string)
        }),
    ])
}

const QUALITY: &str = "ω0/c of linear damping, 2πE/ΔE at the largest cycle of any other, or null";

fn quality(answer: &FitTraceResult<'_>) -> Result<Quality, String> {
    answer.swings.quality().ok_or_else(|| "there is no damping, or no cycle".to_owned())
}

fn rms(answer: &FitTraceResult<'_>, observable: Observable) -> Option<f64> {
    (answer.measured.traces[0].observable() == observable).then_some(answer.swings.fit.rms)
}

/// Gravity with the length that was given.
fn of_gravity<'a>() -> Fields<(&'a Budget, Quantity)> {
    type Of<'a> = Field<(&'a Budget, Quantity)>;
    Fields::from([
        Of::number("length_m", "m", "length of the pendulum that was given", |(_, length)| length.value),
        Of::known(
            "length_uncertainty_m",
            "m",
            "standard uncertainty of that length, or null",
            |(_, length)| length.uncertainty.ok_or_else(|| "the length was given without one".to_owned()),
        ),
        Of::number("gravity_m_per_s2", "m/s²", "acceleration of free fall, with a length", |(budget, _)| {
            budget.g
        }),
        Of::number(
            "gravity_uncertainty_m_per_s2",
            "m/s²",
            "standard uncertainty of gravity",
            |(budget, _)| budget.uncertainty,
        ),
    ])
}

fn of_length() -> Fields<Uncertain> {
    type Of = Field<Uncertain>;
    Fields::from([
        Of::number(
            "length_in_standard_gravity_m",
            "m",
            "length that the period has in standard gravity, without a length",
            |length| length.value,
        ),
        Of::number(
            "length_in_standard_gravity_uncertainty_m",
            "m",
            "standard uncertainty of that length",
            |length| length.uncertainty,
        ),
        Of::note(|_| Some(in_words("give <--length> to obtain gravity"))),
    ])
}

/// The warnings, and the tests by which the fit may be judged.
fn of_doubts<'a>() -> Fields<FitTraceResult<'a>> {
    type Of<'a> = Field<FitTraceResult<'a>>;
    let warnings = warnings::fields(
        |result: &FitTraceResult<'a>| json::list(result.warnings()),
        |result| json::list(result.swings.warnings.iter().map(Warning::name)),
    );
    Fields::from(warnings).and([
        Of::value("advice[]", "", "advice for a better measurement", |result| json::list(result.advice())),
        Of::value("advice_kinds[]", "", "kind of each piece of advice, in the same order", |result| {
            json::list(result.swings.advice.iter().map(Advice::name))
        }),
        Of::nested("traces[].", &of_trace(), |result| of_trace().records(&traces(result))),
        Of::nested("findings[].", &of_file(), |result| of_file().records(&result.measured.files)),
        Of::nested("comparison[].", &of_model(), |result| match &result.swings.comparison {
            Some(comparison) => of_model().records(&models(result, comparison)),
            None => Value::Null,
        }),
        Of::nested("averaged.", &model::of_averages(), |result| {
            result.swings.comparison.as_ref().map_or(Value::Null, model::averaged)
        }),
        Of::value(
            "correlations[][]",
            "1",
            "correlation coefficients of the parameters, in their order",
            |result| json::list(result.swings.fit.correlations.iter().map(|row| json::numbers(row))),
        ),
        Of::nested("autocorrelation.", &of_residuals(), |result| of_residuals().record(result).into()),
    ])
}

fn of_file() -> Fields<File> {
    type Of = Field<File>;
    Fields::from([
        Of::value("file", "", "name of the file", |file| file.name.as_str().into()),
        Of::value("findings[]", "", "settings inferred from it", |file| json::list(file.findings.clone())),
    ])
}

fn of_residuals<'a>() -> Fields<FitTraceResult<'a>> {
    type Of<'a> = Field<FitTraceResult<'a>>;
    Fields::from([
        Of::value("is_noise", "", "true if the residuals are consistent with white noise", |result| {
            result.swings.fit.autocorrelation.is_noise().into()
        }),
        Of::number("correlation_time_rows", "1", "rows after which residuals are independent", |result| {
            result.swings.fit.autocorrelation.time
        }),
        Of::number(
            "excess",
            "1",
            "Ljung and Box's statistic less its mean for noise, over its standard deviation",
            |result| result.swings.fit.autocorrelation.excess,
        ),
        Of::value(
            "bootstrap_block_rows",
            "1",
            "rows of a block of the bootstrap, null where none was needed",
            |result| result.swings.fit.bootstrap_block.into(),
        ),
    ])
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        of_fit().described(""),
        normal_gravity::fields().described(""),
        budget::described(),
        of_gravity().described(""),
        of_length().described(""),
        of_doubts().described(""),
    ];
    vec![Answers { command: "fit trace", option: "", json: json.concat(), csv: of_row().described_in_csv() }]
}
