//! The angle in time: at several amplitudes against the small-angle cosine, or one motion against its
//! approximations.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::cusps::sizes;
use super::range::{around, decades};
use super::style;
use libration::pendulum::{ApproximateMotion, Motion};

const SAMPLES: u32 = 800;

/// A release from rest: the label of its amplitude, the amplitude (rad) and the motion.
pub(crate) struct DrawnRelease {
    pub(crate) label: String,
    pub(crate) amplitude: f64,
    pub(crate) motion: Motion,
}

/// An approximate motion: its name, and its angle (rad) at a time (s).
pub(crate) struct Approximation<'a> {
    pub(crate) name: &'static str,
    pub(crate) angle_at: Box<dyn Fn(f64) -> f64 + 'a>,
}

/// θ/θ0 at several amplitudes against the small-angle cosine; the motions belong to a pendulum with T0 = 1.
pub(crate) fn releases(releases: &[DrawnRelease], periods: f64) -> Picture {
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
    let x = Axis::linear("time t / T₀", 0.0, periods);
    let y = Axis::linear("angle θ / θ₀", -1.1, 1.1);
    Picture::new("Motion after release from rest", vec![Panel { x, y, series, share: 1.0 }])
}

/// One motion with its approximations, and the size of their errors below.
pub(crate) fn compared(
    motion: &Motion,
    approximations: &[Approximation<'_>],
    (from, to): (f64, f64),
) -> Picture {
    let to = if to > from { to } else { from + 1.0 };
    let times: Vec<f64> = evenly(from, to, SAMPLES).collect();
    let exact: Vec<f64> = times.iter().map(|&time| motion.state_at(time).angle).collect();
    let angles = times.iter().zip(&exact).map(|(&time, angle)| (time, angle.to_degrees()));
    let angles: Vec<(f64, f64)> = angles.collect();
    let exact_curve = Series::line("exact", style::curve(0), angles.iter().copied());
    // Beneath and above the approximations, so that none of them hides it.
    let beneath = Series::line("", style::curve(0).beneath(), angles);
    let mut angles = if approximations.is_empty() { vec![] } else { vec![beneath] };
    let mut errors = vec![];
    for (number, approximation) in (1..).zip(approximations) {
        let approximate: Vec<f64> = times.iter().map(|&time| (approximation.angle_at)(time)).collect();
        let degrees = times.iter().zip(&approximate).map(|(&time, angle)| (time, angle.to_degrees()));
        angles.push(Series::line(approximation.name, style::curve(number), degrees));
        let difference = approximate.iter().zip(&exact).map(|(angle, exact)| (angle - exact).to_degrees());
        let signed: Vec<(f64, f64)> = times.iter().copied().zip(difference).collect();
        errors.push(Series::line("", style::curve(number), sizes(&signed)));
    }
    angles.push(Series { look: Look { width: 1.2, ..exact_curve.look }, ..exact_curve });
    Picture::new("Motion of the pendulum", panels(angles, errors, (from, to)))
}

fn panels(angles: Vec<Series>, errors: Vec<Series>, (from, to): (f64, f64)) -> Vec<Panel> {
    let (low, high) = around(values(&angles));
    let y = Axis::linear("angle θ / degrees", low, high).in_units(Units::Degrees);
    let x = Axis::linear("time t / s", from, to);
    if errors.is_empty() {
        return vec![Panel { x, y, series: angles, share: 1.0 }];
    }
    let (low, high) = decades(errors.iter().map(|series| values([series]).fold(0.0, f64::max)));
    let error = Axis::logarithmic("|error| / degrees", low, high);
    let unlabelled = x.unlabelled();
    vec![
        Panel { x: unlabelled, y, series: angles, share: 0.55 },
        Panel { x, y: error, series: errors, share: 0.45 },
    ]
}

fn values<'a>(series: impl IntoIterator<Item = &'a Series>) -> impl Iterator<Item = f64> {
    series.into_iter().flat_map(|series| series.points.iter().map(|point| point.y))
}

/// Values from one end to the other in equal steps.
fn evenly(from: f64, to: f64, steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| from + (to - from) * f64::from(step) / f64::from(steps))
}
