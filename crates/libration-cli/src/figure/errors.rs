//! The fractional error of period formulas against the amplitude, as in the first figure of Black and Vel.

use super::chart::{Axis, Panel, Picture, Series};
use super::range::tick_step;
use super::style;

const SAMPLES: u32 = 720;
/// Halvings of a step in which the error changes sign: enough to leave nothing but rounding.
const HALVINGS: u32 = 60;

/// A formula's name for the legend and its signed fractional error at an amplitude in degrees.
pub(crate) struct Curve<'a> {
    pub(crate) label: String,
    pub(crate) error: Box<dyn Fn(f64) -> f64 + 'a>,
}

/// The frame of the picture: amplitudes in degrees, and the errors at the ends of the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
}

/// The picture of the errors; where an error changes sign its curve runs down to the axis.
pub(crate) fn errors(curves: &[Curve], frame: Frame) -> Picture {
    let series = curves.iter().enumerate().map(|(number, curve)| {
        Series::line(&curve.label, style::curve(number), sizes(curve, frame))
    });
    let step = if frame.to - frame.from > 90.0 { 30.0 } else { tick_step(frame.from, frame.to) };
    let panel = Panel {
        x: Axis::linear("amplitude θ₀ / degrees", frame.from, frame.to).with_tick_step(step),
        y: Axis::logarithmic("|fractional error of T|", frame.lowest, frame.highest),
        series: series.collect(),
        share: 1.0,
    };
    Picture::new("Error of formulas for the period", vec![panel])
}

/// The size of the error at even steps, and at each change of sign the lowest visible size.
fn sizes(curve: &Curve, frame: Frame) -> Vec<(f64, f64)> {
    let amplitude = |step| frame.from + (frame.to - frame.from) * f64::from(step) / f64::from(SAMPLES);
    let mut points: Vec<(f64, f64)> = vec![];
    let mut last: Option<(f64, f64)> = None;
    for here in (0..=SAMPLES).map(amplitude) {
        let error = (curve.error)(here);
        if let Some((before, error_before)) = last
            && error_before * error < 0.0
        {
            points.extend(cusp(curve, before, here, frame.lowest));
        }
        points.push((here, error.abs().max(f64::MIN_POSITIVE)));
        last = Some((here, error));
    }
    points
}

/// The approach to a change of sign from both sides, in steps that halve.
fn cusp(curve: &Curve, mut low: f64, mut high: f64, lowest: f64) -> Vec<(f64, f64)> {
    let mut left = vec![];
    let mut right = vec![];
    let sign_before = (curve.error)(low) > 0.0;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        let error = (curve.error)(middle);
        if (error > 0.0) == sign_before {
            low = middle;
            left.push((middle, error.abs()));
        } else {
            high = middle;
            right.push((middle, error.abs()));
        }
    }
    left.push((low, lowest.min(f64::MIN_POSITIVE)));
    left.into_iter().chain(right.into_iter().rev()).filter(|(_, error)| *error > 0.0).collect()
}
