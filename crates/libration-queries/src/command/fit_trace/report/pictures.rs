//! The pictures of the report.

use super::super::answer::FitTraceResult;
use crate::document::{Block, DocumentFigure};
use crate::figure::chart::Picture;
use crate::figure::parameters::estimate;
use crate::figure::trace::{self as draw, Envelope, Fitted, Swings};
use libration_lab::fit::cycles::HalfSwing;
use libration_lab::fit::trace::{ParameterKind, TraceFit};
use libration_lab::measurement::Observable;

fn figure(name: &str, caption: String, picture: Picture) -> Block {
    Block::Figure(DocumentFigure { name: name.to_owned(), caption, picture })
}

fn swing<'a>(answer: &'a FitTraceResult<'_>, trace: usize) -> Fitted<'a> {
    Fitted {
        trace: &answer.measured.traces[trace],
        fitted: &answer.swings.fit.traces[trace],
        small_angle_period: answer.swings.fit.small_angle_period().value,
    }
}

/// The picture of `--figure`: the data of all traces with the fitted motions, and the residuals.
pub(in super::super) fn of_all(answer: &FitTraceResult<'_>) -> Picture {
    let count = answer.measured.traces.len();
    let pictures: Vec<Picture> = (0..count).map(|trace| of_one_of(answer, trace)).collect();
    let aspect =
        pictures.iter().map(|picture| if count > 1 { 0.7 * picture.aspect } else { picture.aspect }).sum();
    let panels = pictures.into_iter().flat_map(|picture| picture.panels).collect();
    let t0 = estimate("T₀", answer.swings.small_angle_period(), "s");
    let picture = Picture::new("Swing and fitted motion", panels);
    let damping = format!("damping: {}", answer.swings.fit.damping);
    Picture { aspect, ..picture.with_parameters([t0, damping]) }
}

/// The data and the residuals of one trace, which is named by its time axis if there are several.
fn of_one_of(answer: &FitTraceResult<'_>, trace: usize) -> Picture {
    let mut picture = draw::whole(&swing(answer, trace), "");
    if answer.measured.traces.len() > 1
        && let Some(lowest) = picture.panels.last_mut()
    {
        lowest.x.label = format!("{} ({})", lowest.x.label, answer.measured.traces[trace].name());
    }
    picture
}

/// The name of a trace, for file names and titles; empty for a trace alone.
fn suffix(answer: &FitTraceResult<'_>, trace: usize) -> String {
    if answer.measured.traces.len() > 1 { format!("-{}", trace + 1) } else { String::new() }
}

pub(super) fn of_motion(answer: &FitTraceResult<'_>) -> Vec<Block> {
    (0..answer.measured.traces.len()).flat_map(|trace| of_trace(answer, trace)).collect()
}

fn of_trace(answer: &FitTraceResult<'_>, trace: usize) -> Vec<Block> {
    let (swing, suffix) = (swing(answer, trace), suffix(answer, trace));
    let name = swing.trace.name();
    let whole = format!("All rows of {name} with the fitted motion; below, their residuals");
    let mut blocks = vec![figure(&format!("swing{suffix}"), whole, draw::whole(&swing, name))];
    if draw::is_long(&swing) {
        let parts = format!("Four periods at the beginning, in the middle and at the end of {name}");
        blocks.push(figure(&format!("parts{suffix}"), parts, draw::stretches(&swing, name)));
    }
    blocks
}

pub(super) fn of_residuals(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let residuals = answer.swings.fit.traces.iter().flat_map(|trace| trace.residuals.iter().copied());
    let residuals: Vec<f64> = residuals.collect();
    let caption = "Above, the autocorrelation of the residuals against the lag in rows: between the dashed lines, if they are \
                   white noise. Below, the distribution of the residuals, with the normal distribution";
    let picture = draw::residuals(&answer.swings.fit.autocorrelation, &residuals);
    vec![figure("residuals", caption.to_owned(), picture)]
}

pub(super) fn of_periods(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let alone = answer.measured.traces.len() == 1;
    let named = answer.measured.traces.iter().zip(&answer.swings.cycles);
    let swings: Vec<Swings<'_>> = named
        .filter_map(|(trace, outcome)| {
            let cycles = &outcome.as_ref().ok()?.cycles;
            Some(Swings { name: if alone { "" } else { trace.name() }, cycles })
        })
        .collect();
    if answer.swings.all_cycles().next().is_none() {
        return vec![];
    }
    let beta = answer.swings.beta.as_ref().ok().map(|beta| (beta.factor.value, beta.t0.value));
    let caption = "The period of every cycle against its amplitude, with the exact law for the fitted T₀, the constant period of the \
                   small-angle formula, and the law with the fitted β";
    let picture = draw::periods(&swings, answer.swings.small_angle_period().value, beta);
    vec![figure("periods", caption.to_owned(), picture)]
}

/// The amplitudes of each trace with the laws of the models.
pub(super) fn of_damping(answer: &FitTraceResult<'_>) -> Vec<Block> {
    let traces = 0..answer.measured.traces.len();
    traces.filter_map(|trace| of_amplitudes(answer, trace)).collect()
}

fn of_amplitudes(answer: &FitTraceResult<'_>, trace: usize) -> Option<Block> {
    let half_swings = &answer.swings.cycles[trace].as_ref().ok()?.half_swings;
    let name = answer.measured.traces[trace].name();
    let caption = format!(
        "The largest angle of every half swing of {name}, with those of the fitted motions; below, all of them less that of {} \
         damping",
        answer.swings.fit.damping
    );
    let others = answer.swings.comparison.iter().flat_map(|comparison| &comparison.fits);
    let others = others.filter(|fit| fit.damping.count() == 1 && fit.damping != answer.swings.fit.damping);
    let of_model = |fit: &TraceFit| of_model(answer, fit, trace, half_swings);
    let others: Vec<Envelope> = others.filter_map(of_model).collect();
    let picture = draw::amplitudes(name, half_swings, of_model(&answer.swings.fit).as_ref(), &others);
    Some(figure(&format!("amplitudes{}", suffix(answer, trace)), caption, picture))
}

/// The amplitude of a model's fitted motion in each half swing.
fn of_model(
    answer: &FitTraceResult<'_>,
    fit: &TraceFit,
    trace: usize,
    half_swings: &[HalfSwing],
) -> Option<Envelope> {
    let measured = &answer.measured.traces[trace];
    let offset_parameter =
        fit.parameters.iter().find(|each| each.trace == Some(trace) && each.kind == ParameterKind::Offset);
    let offset = offset_parameter?.estimate.value;
    let sizes: Vec<f64> = fit.traces[trace].fitted.iter().map(|value| (value - offset).abs()).collect();
    let window = fit.small_angle_period().value / 6.0;
    let amplitude = |half: &HalfSwing| {
        let extreme = extreme(measured.times(), &sizes, half.time, window).unwrap_or(f64::NAN);
        match measured.observable() {
            Observable::Angle => extreme,
            // At the bottom θ′ = 2ω₀ sin(θ₀/2).
            Observable::AngularVelocity => 2.0 * (0.5 * extreme / fit.parameters[0].estimate.value).asin(),
        }
    };
    Some(Envelope { name: fit.damping.to_string(), amplitudes: half_swings.iter().map(amplitude).collect() })
}

/// The largest value near a time: the vertex of the parabola through the largest row and its neighbours.
fn extreme(times: &[f64], sizes: &[f64], near: f64, window: f64) -> Option<f64> {
    let from = times.partition_point(|&time| time < near - window).max(1);
    let to = times.partition_point(|&time| time < near + window).min(sizes.len().saturating_sub(1));
    let row = (from..to).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]))?;
    let (before, after) = (times[row] - times[row - 1], times[row + 1] - times[row]);
    let (rise, fall) = ((sizes[row] - sizes[row - 1]) / before, (sizes[row + 1] - sizes[row]) / after);
    let curvature = (fall - rise) / (before + after);
    let slope = (rise * after + fall * before) / (before + after);
    let shift = -0.5 * slope / curvature;
    let is_a_turn = curvature < 0.0 && shift.abs() <= before.max(after);
    is_a_turn.then_some(0.5_f64.mul_add(slope * shift, sizes[row]))
}
