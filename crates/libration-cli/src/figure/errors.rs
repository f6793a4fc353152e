//! The fractional error of period formulas against the amplitude, as in the first figure of Black and Vel.

use super::chart::{Axis, Panel, Picture, Series};
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
    let x = Axis::linear("amplitude θ₀ / degrees", frame.from, frame.to);
    let panel = Panel {
        x: if frame.to - frame.from > 90.0 { x.with_tick_step(30.0) } else { x },
        y: Axis::logarithmic("|fractional error of T|", frame.lowest, frame.highest),
        series: series.collect(),
        share: 1.0,
    };
    Picture::new("Error of formulas for the period", vec![panel])
}

/// The size of the error at even steps, and around each change of sign.
fn sizes(curve: &Curve, frame: Frame) -> Vec<(f64, f64)> {
    let amplitudes: Vec<f64> = amplitudes(frame).collect();
    let signed: Vec<(f64, f64)> = amplitudes.into_iter().map(|here| (here, (curve.error)(here))).collect();
    let mut points = vec![];
    for pair in signed.windows(2) {
        points.push(size(pair[0]));
        if pair[0].1 * pair[1].1 < 0.0 {
            points.extend(cusp(curve, pair[0].0, pair[1].0));
        }
    }
    points.extend(signed.last().copied().map(size));
    points
}

/// Even steps, and the approach to the right end, where formulas and period may be infinite.
fn amplitudes(frame: Frame) -> impl Iterator<Item = f64> {
    let step = (frame.to - frame.from) / f64::from(SAMPLES);
    let even = (0..SAMPLES).map(move |k| frame.from + step * f64::from(k));
    even.chain([0.1, 0.01, 0.001].map(|part| frame.to - part * step))
}

fn size((amplitude, error): (f64, f64)) -> (f64, f64) {
    (amplitude, if error.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { error.abs() })
}

/// The approach to a change of sign from both sides, in steps that halve.
fn cusp(curve: &Curve, mut low: f64, mut high: f64) -> Vec<(f64, f64)> {
    let mut left = vec![];
    let mut right = vec![];
    let positive_before = (curve.error)(low) > 0.0;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        let error = (curve.error)(middle);
        if (error > 0.0) == positive_before {
            low = middle;
            left.push(size((middle, error)));
        } else {
            high = middle;
            right.push(size((middle, error)));
        }
    }
    left.push((f64::midpoint(low, high), f64::MIN_POSITIVE));
    left.into_iter().chain(right.into_iter().rev()).collect()
}
