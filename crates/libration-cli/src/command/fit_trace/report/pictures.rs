//! The pictures of the report.

use super::super::answer::Answer;
use crate::document::{Block, Figure};
use crate::figure::chart::Picture;
use crate::figure::trace::{self as draw, Envelope, Fitted, Swings};
use libration::decay::{Damping, DampingTerm, Decay, Law};
use libration::fit::cycles::HalfSwing;
use libration::fit::trace::TraceFit;
use libration::measurement::{Seen, Trace};
use libration::pendulum::Pendulum;
use libration::quantity::Angle;

/// Points of an envelope.
const SAMPLES: u32 = 200;

fn figure(name: &str, caption: String, picture: Picture) -> Block {
    Block::Figure(Figure { name: name.to_owned(), caption, picture })
}

fn swing<'a>(answer: &'a Answer<'_>, trace: usize) -> Fitted<'a> {
    Fitted {
        trace: &answer.measured.traces[trace],
        fitted: &answer.fit.traces[trace],
        small_angle_period: answer.fit.small_angle_period().0,
    }
}

/// What `--figure` draws: the data of all traces with the motion, and what is left.
pub(in super::super) fn of_all(answer: &Answer<'_>) -> Picture {
    let count = answer.measured.traces.len();
    let pictures: Vec<Picture> =
        (0..count).map(|trace| draw::whole(&swing(answer, trace), "Swing and fit")).collect();
    let height =
        pictures.iter().map(|picture| if count > 1 { 0.7 * picture.height } else { picture.height }).sum();
    let panels = pictures.into_iter().flat_map(|picture| picture.panels).collect();
    Picture { height, ..Picture::new("Swing and fitted motion", panels) }
}

/// The name of a trace, for file names and titles; empty for a trace alone.
fn suffix(answer: &Answer<'_>, trace: usize) -> String {
    if answer.measured.traces.len() > 1 { format!("-{}", trace + 1) } else { String::new() }
}

pub(super) fn of_motion(answer: &Answer<'_>) -> Vec<Block> {
    (0..answer.measured.traces.len()).flat_map(|trace| of_trace(answer, trace)).collect()
}

fn of_trace(answer: &Answer<'_>, trace: usize) -> Vec<Block> {
    let (swing, suffix) = (swing(answer, trace), suffix(answer, trace));
    let name = swing.trace.name();
    let whole = format!("All rows of {name} with the fitted motion; below, what is left between them");
    let mut blocks = vec![figure(&format!("swing{suffix}"), whole, draw::whole(&swing, name))];
    if draw::is_long(&swing) {
        let parts = format!("Four periods at the beginning, in the middle and at the end of {name}");
        blocks.push(figure(&format!("parts{suffix}"), parts, draw::stretches(&swing, name)));
    }
    blocks
}

pub(super) fn of_residuals(answer: &Answer<'_>) -> Vec<Block> {
    let residuals = answer.fit.traces.iter().flat_map(|trace| trace.residuals.iter().copied());
    let residuals: Vec<f64> = residuals.collect();
    let caption = "Above, how alike residuals are that are so many rows apart: between the dashed lines, if they are noise. \
                   Below, how many residuals there are of each size, beside the normal distribution";
    let picture = draw::residuals(&answer.fit.autocorrelation, &residuals);
    vec![figure("residuals", caption.to_owned(), picture)]
}

pub(super) fn of_periods(answer: &Answer<'_>) -> Vec<Block> {
    let alone = answer.measured.traces.len() == 1;
    let named = answer.measured.traces.iter().zip(&answer.cycles);
    let swings: Vec<Swings<'_>> = named
        .filter_map(|(trace, found)| {
            let cycles = &found.as_ref().ok()?.cycles;
            Some(Swings { name: if alone { "" } else { trace.name() }, cycles })
        })
        .collect();
    if answer.all_cycles().next().is_none() {
        return vec![];
    }
    let beta = answer.beta.as_ref().ok().map(|beta| (beta.value, beta.t0));
    let caption = "The period of every cycle against its amplitude, with the exact law for the fitted T₀, the constant period of the \
                   small-angle formula, and the law with the fitted β";
    let picture = draw::periods(&swings, answer.fit.small_angle_period().0, beta);
    vec![figure("periods", caption.to_owned(), picture)]
}

/// The amplitudes of each trace with the laws of the models.
pub(super) fn of_damping(answer: &Answer<'_>) -> Vec<Block> {
    let traces = 0..answer.measured.traces.len();
    traces.filter_map(|trace| of_amplitudes(answer, trace)).collect()
}

fn of_amplitudes(answer: &Answer<'_>, trace: usize) -> Option<Block> {
    let half_swings = &answer.cycles[trace].as_ref().ok()?.half_swings;
    let name = answer.measured.traces[trace].name();
    let caption = format!(
        "The largest angle of every half swing of {name}, with the laws of decay of the fitted models, averaged over cycles of \
         any amplitude; below, all of them less that of {} damping",
        answer.fit.damping
    );
    let others = answer.comparison.iter().flat_map(|comparison| &comparison.fits);
    let others = others.filter(|fit| fit.damping.count() == 1 && fit.damping != answer.fit.damping);
    let others: Vec<Envelope> = others.filter_map(|fit| envelope(answer, fit, trace, half_swings)).collect();
    let chosen = envelope(answer, &answer.fit, trace, half_swings);
    let picture = draw::amplitudes(name, half_swings, chosen.as_ref(), &others);
    Some(figure(&format!("amplitudes{}", suffix(answer, trace)), caption, picture))
}

/// The averaged law of decay of a model; none for a motion over the top or without damping.
fn envelope(
    answer: &Answer<'_>,
    fit: &TraceFit,
    trace: usize,
    half_swings: &[HalfSwing],
) -> Option<Envelope> {
    let measured = &answer.measured.traces[trace];
    let pendulum = Pendulum::from_angular_frequency(fit.parameters[0].value).ok()?;
    let scale = fit.parameter("scale").map_or(1.0, |scale| scale.value);
    let (start, amplitude) = match measured.seen() {
        Seen::Angle => first_turn(measured, fit, trace, half_swings.first()?)?,
        Seen::AngularVelocity => (measured.times()[0], first_amplitude(&pendulum, fit, trace)?),
    };
    let decay = Decay::new(pendulum, damping(fit)?, Angle::from_radians(amplitude / scale).ok()?).ok()?;
    let law = decay.envelope(Law::Averaged);
    let at = |time: f64| scale * law.amplitude_at(time - start);
    let last = measured.times()[measured.len() - 1];
    let time = |step: u32| start + (last - start) * f64::from(step) / f64::from(SAMPLES);
    let points = (0..=SAMPLES).map(|step| (time(step), at(time(step)))).collect();
    let at_half_swings = half_swings.iter().map(|half| at(half.time)).collect();
    Some(Envelope { name: fit.damping.to_string(), points, at_half_swings })
}

/// When and how far the fitted motion turns nearest to a measured half swing: there, and not between, the averaged law
/// and the motion agree.
fn first_turn(measured: &Trace, fit: &TraceFit, trace: usize, near: &HalfSwing) -> Option<(f64, f64)> {
    let (times, offset) = (measured.times(), own(fit, trace, "offset")?);
    let sizes: Vec<f64> = fit.traces[trace].fitted.iter().map(|value| (value - offset).abs()).collect();
    let window = fit.small_angle_period().0 / 6.0;
    let rows = (1..sizes.len().saturating_sub(1)).filter(|&row| (times[row] - near.time).abs() < window);
    let row = rows.max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]))?;
    let (before, after) = (times[row] - times[row - 1], times[row + 1] - times[row]);
    let (rise, fall) = ((sizes[row] - sizes[row - 1]) / before, (sizes[row + 1] - sizes[row]) / after);
    // The vertex of the parabola through three rows.
    let curvature = (fall - rise) / (before + after);
    let slope = (rise * after + fall * before) / (before + after);
    let shift = -0.5 * slope / curvature;
    let is_a_turn = curvature < 0.0 && shift.abs() <= before.max(after);
    is_a_turn.then_some((times[row] + shift, 0.5_f64.mul_add(slope * shift, sizes[row])))
}

/// The amplitude that the energy at the first row is enough for.
fn first_amplitude(pendulum: &Pendulum, fit: &TraceFit, trace: usize) -> Option<f64> {
    let angle = Angle::from_radians(own(fit, trace, "theta0")?).ok()?;
    let motion = pendulum.launched(angle, own(fit, trace, "velocity0")?).ok()?;
    motion.amplitude().map(|amplitude| amplitude.radians())
}

/// A parameter that a trace has for itself.
fn own(fit: &TraceFit, trace: usize, name: &str) -> Option<f64> {
    let found = fit.parameters.iter().find(|each| each.trace == Some(trace) && each.name == name);
    found.map(|parameter| parameter.value)
}

fn damping(fit: &TraceFit) -> Option<Damping> {
    let term = |(name, exponent)| {
        let coefficient = fit.parameter(name)?.value;
        Some(DampingTerm { exponent, coefficient })
    };
    let terms = [("dry", 0.0), ("linear", 1.0), ("quadratic", 2.0)].into_iter().filter_map(term);
    Damping::new(&terms.collect::<Vec<_>>()).ok()
}
