//! Text of the report.

use super::super::answer::FitTraceResult;
use super::super::{sheet, units};
use crate::call::in_words;
use crate::command::fit_report::sentence;
use crate::document::{Block, DocumentTable};
use crate::output::number::{self, rounded, with_uncertainty};
use crate::output::table::Column;
use libration_lab::fit::swings::FittedPendulum;
use libration_lab::fit::{DampingKind, Uncertain, alternatives};

/// The few numbers that were requested.
pub(super) fn result(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let period = answer.swings.small_angle_period();
    let (name, value) = sheet::gravity_or_length(answer);
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let mut rows = vec![
        row("period of small swings T₀", number::quantity(period, "s")),
        row(name, value),
        row("damping", sheet::model(answer)),
        row("β, the test of the exact law", sheet::beta(answer)),
        row("rms residual", sheet::residual(answer)),
    ];
    let value = std::f64::consts::TAU / period.value;
    let speed = Uncertain { value, uncertainty: value * period.relative() };
    rows.insert(1, row("ω₀ = 2π/T₀", number::quantity(speed, "rad/s")));
    if let Some(expanded) = sheet::expanded(answer) {
        rows.insert(3, row("expanded uncertainty of gravity", expanded));
    }
    let table = DocumentTable {
        caption: "Results of the measurement".to_owned(),
        columns: vec![Column::words("quantity"), Column::words("value")],
        rows,
    };
    vec![Block::Table(table)]
}

/// The meaning of the result.
pub(super) fn meaning(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let meaning = "The number after ± is the standard uncertainty: the true value lies within it with a probability of 68 %, \
                   and within twice as much with 95 %, if the errors are random.";
    vec![Block::words(meaning), Block::words(formula(answer))]
}

/// The formula for gravity or the length.
fn formula(answer: &FitTraceResult<'_>) -> &'static str {
    match answer.swings.pendulum {
        FittedPendulum::Gravity { .. } => {
            "Gravity is g = ω₀² l with the corrections of the budget below, which shows the sources of its uncertainty."
        }
        FittedPendulum::Length(_) => {
            "The length is l = g/ω₀², that of a point on a string without mass; for a body it is that of the simple pendulum \
             with the same period."
        }
    }
}

/// The files with the settings inferred from them.
pub(super) fn read(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let file = |file: &super::super::input::File| {
        let items = file.findings.iter().map(|text| sentence(text)).collect();
        [Block::words(format!("{}:", file.name)), Block::List(items)]
    };
    let rows = format!(
        "{} rows in {} {} were fitted. {}",
        answer.swings.fit.rows(),
        answer.measured.traces.len(),
        if answer.measured.traces.len() == 1 { "trace" } else { "traces" },
        in_words("An option in parentheses, such as <--angle-unit>, overrides what was detected.")
    );
    answer.measured.files.iter().flat_map(file).chain([Block::words(rows)]).collect()
}

pub(super) fn residuals(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let autocorrelation = &answer.swings.fit.autocorrelation;
    let verdict = if autocorrelation.is_noise() {
        "They look like white noise: neighbouring residuals are uncorrelated, as reading errors are."
    } else {
        "They are not white noise: neighbouring residuals are correlated, so something other than reading errors contributes, and \
         more rows of the same kind would improve the result less than their number suggests."
    };
    vec![Block::words(format!(
        "The residuals, data minus fitted motion, have a root mean square of {}. If the model and the instrument are right they \
         are noise. {verdict}",
        sheet::residual(answer)
    ))]
}

pub(super) fn periods(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let law = "A pendulum takes longer for large swings: T = T₀·R(θ₀), where R is 1 for the smallest swings and 1 + θ₀²/16 + … \
               beyond (1.017 at 30°, 1.18 at 90°). Here every cycle was timed separately, without a model of the damping, and \
               T = T₀·[1 + β(R − 1)] was fitted to the cycles. A pendulum has β = 1; a clock that kept its period would have β = 0.";
    let verdict = match &answer.swings.beta {
        Err(reason) => format!("β cannot be determined: {reason}."),
        Ok(beta) if beta.differs_from_one() => format!(
            "β = {}: this is {} uncertainties from 1. A wrong scale of the angles is the usual reason.",
            beta.factor,
            rounded(beta.deviation(), 2)
        ),
        Ok(beta) => format!(
            "β = {}, which agrees with the exact law and with a right scale of the angles.",
            beta.factor
        ),
    };
    vec![Block::words(law), Block::words(verdict)]
}

pub(super) fn damping(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let equation = "The equation of motion is θ″ = −ω₀² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′|: dry friction d in the bearing, linear \
                    drag b of slow flow and in the string, quadratic drag c of fast flow around the bob. Small amplitudes fall as a \
                    straight line, as an exponential, and as 1/(t + constant).";
    let Some(comparison) = &answer.swings.comparison else {
        return vec![
            Block::words(equation),
            Block::words(format!("Only {} damping was fitted, as requested.", answer.swings.fit.damping)),
        ];
    };
    let rivals = answer.swings.rivals();
    let verdict = match (rivals.len(), comparison.better().count()) {
        (0, 0) => format!("The simplest description that the data allow is {}.", named(answer)),
        (0, _) => format!(
            "The simplest description in which friction only brakes is {}, but another model fits the data better: see the warnings.",
            named(answer)
        ),
        _ => format!(
            "The simplest description is {}, but these data do not exclude {}: T₀ and gravity are averaged over them, and the \
             coefficients of damping differ from one to the other.",
            named(answer),
            alternatives(&rivals)
        ),
    };
    let counted = sheet::counted_rows(answer, comparison);
    vec![Block::words(equation), Block::words(verdict), Block::words(counted)]
}

/// `linear damping (b = 0.030 ± 0.001 1/s)`.
fn named(answer: &FitTraceResult<'_>) -> String {
    let letter = |term: DampingKind| match term {
        DampingKind::Dry => "d",
        DampingKind::Linear => "b",
        DampingKind::Quadratic => "c",
    };
    let coefficient = |term: DampingKind| {
        let parameter = answer.swings.fit.damping_coefficient(term)?;
        let unit = units::unit(term.unit());
        Some(format!(
            "{} = {}",
            letter(term),
            with_uncertainty(parameter.estimate.value, parameter.estimate.uncertainty, &unit)
        ))
    };
    let coefficients: Vec<String> = answer.swings.fit.damping.iter().filter_map(coefficient).collect();
    match coefficients.len() {
        0 => "no damping at all".to_owned(),
        _ => format!("{} damping ({})", answer.swings.fit.damping, coefficients.join(", ")),
    }
}

pub(super) fn numbers(_answer: &FitTraceResult<'_>) -> Vec<Block> {
    vec![Block::words(
        "omega0 is ω₀ = √(g/l); dry, linear and quadratic are d, b and c. offset is where the pendulum hangs on the scale of the \
         instrument, theta0 and velocity0 are the angle from there and the angular velocity at the first row.",
    )]
}
