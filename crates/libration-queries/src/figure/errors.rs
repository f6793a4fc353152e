//! The fractional error of period formulas against the amplitude, as in the first figure of Black and Vel.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::cusps::sizes;
use super::style;
use crate::parallel;
use libration::progress::Status;

const SAMPLES: u32 = 720;

/// A formula's name for the legend and its signed fractional error at an amplitude in degrees.
pub(crate) struct Curve {
    pub(crate) label: String,
    pub(crate) error: Box<dyn Fn(f64) -> f64 + Send + Sync>,
}

/// The frame of the picture: amplitudes in degrees, and the errors at the ends of the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
}

/// The picture of the errors; where an error changes sign its curve runs down to the axis. After a cancellation it has only the curves that
/// are done.
pub(crate) fn errors(curves: Vec<Curve>, frame: Frame) -> Picture {
    let numbered: Vec<(usize, Curve)> = curves.into_iter().enumerate().collect();
    let series = parallel::map_unless_cancelled(&numbered, "curves", |(number, curve), progress| {
        let asked = amplitudes(frame).take_while(|_| progress.update(Status::default()).is_continue());
        let signed: Vec<_> = asked.map(|x| (x, (curve.error)(x))).collect();
        Series::line(&curve.label, style::curve(*number), sizes(&signed))
    });
    let x = Axis::linear("amplitude θ₀ / degrees", frame.from, frame.to);
    let panel = Panel {
        x: x.in_units(Units::Degrees),
        y: Axis::logarithmic("|fractional error of T|", frame.lowest, frame.highest),
        series,
        share: 1.0,
    };
    Picture::new("Fractional error of formulas for the period", vec![panel])
}

/// Even steps, and steps that approach the right end, where formulas and period may be infinite.
fn amplitudes(frame: Frame) -> impl Iterator<Item = f64> {
    let step = (frame.to - frame.from) / f64::from(SAMPLES);
    let even = (0..SAMPLES).map(move |k| frame.from + step * f64::from(k));
    even.chain([0.1, 0.01, 0.001].map(|part| frame.to - part * step))
}
