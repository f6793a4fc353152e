//! The angle in time: at several amplitudes against the small-angle cosine, or one motion against its
//! approximations.

use super::chart::{Axis, Panel, Picture, Series};
use super::range::{around, tick_step};
use super::style;
use crate::command::motion::Comparison;
use libration::pendulum::{ApproximateMotion, Motion};

const SAMPLES: u32 = 800;

/// A release from rest: the label of its amplitude, the amplitude (rad) and the motion.
pub(crate) struct Release {
    pub(crate) label: String,
    pub(crate) amplitude: f64,
    pub(crate) motion: Motion,
}

/// θ/θ0 at several amplitudes against the small-angle cosine; the motions belong to a pendulum with T0 = 1.
pub(crate) fn releases(releases: &[Release], periods: f64) -> Picture {
    let times: Vec<f64> = evenly(0.0, periods, SAMPLES).collect();
    let cosine = ApproximateMotion::CATALOGUE[0];
    let phase = |time: f64| std::f64::consts::TAU * time;
    let mut series = vec![Series::line(
        cosine.name(),
        style::reference(),
        times.iter().map(|&time| (time, cosine.angle(1.0, phase(time)))),
    )];
    for (number, release) in releases.iter().enumerate() {
        let points = times.iter().map(|&t| (t, release.motion.state_at(t).angle / release.amplitude));
        series.push(Series::line(&release.label, style::curve(number), points));
    }
    let x = Axis::linear("time t / T₀", 0.0, periods).with_tick_step(tick_step(0.0, periods));
    let y = Axis::linear("angle θ / θ₀", -1.1, 1.1).with_tick_step(0.5);
    Picture::new("Motion after release from rest", vec![Panel { x, y, series, share: 1.0 }])
}

/// One motion with its approximations, and their errors below.
pub(crate) fn compared(motion: &Motion, comparison: &Comparison, (from, to): (f64, f64)) -> Picture {
    let to = if to > from { to } else { from + 1.0 };
    let times: Vec<f64> = evenly(from, to, SAMPLES).collect();
    let exact: Vec<f64> = times.iter().map(|&time| motion.state_at(time).angle).collect();
    let approximate: Vec<Vec<f64>> = times.iter().map(|&time| comparison.angles_at(time).collect()).collect();
    let mut angles = vec![Series::line(
        "exact",
        style::curve(0),
        times.iter().zip(&exact).map(|(&time, angle)| (time, angle.to_degrees())),
    )];
    let mut errors = vec![];
    for (index, key) in comparison.approximations.iter().map(ApproximateMotion::key).enumerate() {
        let look = style::curve(index + 1);
        let column = || times.iter().zip(&approximate).map(|(&time, row)| (time, row[index]));
        angles.push(Series::line(key, look.clone(), column().map(|(time, angle)| (time, angle.to_degrees()))));
        let differences = column().zip(&exact).map(|((time, angle), exact)| (time, (angle - exact).to_degrees()));
        errors.push(Series::line("", look, differences));
    }
    let mut panels = vec![panel("angle θ / degrees", angles, 0.6, (from, to))];
    if !errors.is_empty() {
        panels.push(panel("error / degrees", errors, 0.4, (from, to)));
    }
    Picture::new("Motion of the pendulum", panels)
}

fn panel(label: &str, series: Vec<Series>, share: f64, (from, to): (f64, f64)) -> Panel {
    let (low, high) = around(series.iter().flat_map(|series| series.points.iter().map(|point| point.y)));
    let x = Axis::linear("time t / s", from, to).with_tick_step(tick_step(from, to));
    let y = Axis::linear(label, low, high).with_tick_step(tick_step(low, high));
    Panel { x, y, series, share }
}

/// This many steps from one end to the other.
fn evenly(from: f64, to: f64, steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| from + (to - from) * f64::from(step) / f64::from(steps))
}
