//! The fractional error of period formulas against the amplitude, as in the first figure of Black and Vel.

use super::chart::{Axis, Panel, Picture, Series, Units};
use super::cusps::sizes;
use super::style;
use crate::parallel;
use libration::progress::{Progress, Status};
use libration::quantity::Angle;

const SAMPLES: u32 = 720;
/// Distances from the top at the ends of the axis of the second panel, in degrees.
const NEAR_TOP: [f64; 2] = [1e-6, 180.0];

/// A formula's name for the legend, its family, and its signed fractional error.
pub(crate) struct ErrorOfFormula {
    pub(crate) label: String,
    pub(crate) family: String,
    pub(crate) error: Box<dyn Fn(&Angle) -> f64 + Send + Sync>,
}

/// The frame of the picture: amplitudes in degrees, and the errors at the ends of the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) lowest: f64,
    pub(crate) highest: f64,
    /// `true` if a second panel shows the errors against the distance from the top.
    pub(crate) has_top: bool,
}

/// The picture of the errors; where an error changes sign its curve runs down to the axis. After a cancellation it has only the curves that
/// are done.
pub(crate) fn errors(curves: &[ErrorOfFormula], frame: Frame) -> Picture {
    let looks = style::of_families(curves.iter().map(|curve| curve.family.as_str()));
    let numbered: Vec<(usize, &ErrorOfFormula)> = curves.iter().enumerate().collect();
    let series = |angles: &(dyn Fn() -> Vec<(f64, Option<Angle>)> + Sync)| {
        parallel::map_unless_cancelled(&numbered, "curves", |(number, curve), progress| {
            Series::line(&curve.label, looks[*number].clone(), sizes(&signed(curve, angles(), progress)))
        })
    };
    let y = Axis::logarithmic("|fractional error of T|", frame.lowest, frame.highest);
    let x = Axis::linear("amplitude θ₀ / degrees", frame.from, frame.to).in_units(Units::Degrees);
    let mut panels = vec![Panel { x, y: y.clone(), series: series(&|| amplitudes(frame)), share: 1.0 }];
    if frame.has_top {
        let x = Axis::logarithmic("π − θ₀ / degrees", NEAR_TOP[0], NEAR_TOP[1]);
        panels.push(Panel { x, y, series: series(&near_top), share: 1.0 });
    }
    let picture = Picture::new("Fractional error of formulas for the period", panels);
    Picture { aspect: if frame.has_top { 1.1 } else { picture.aspect }, ..picture }
}

/// The errors at these positions on the axis.
fn signed(
    curve: &ErrorOfFormula,
    angles: Vec<(f64, Option<Angle>)>,
    progress: &dyn Progress,
) -> Vec<(f64, f64)> {
    let asked = angles.into_iter().take_while(|_| progress.update(Status::default()).is_continue());
    asked.map(|(x, angle)| (x, angle.map_or(f64::NAN, |angle| (curve.error)(&angle)))).collect()
}

/// Even steps, and steps that approach the right end, where formulas and period may be infinite.
fn amplitudes(frame: Frame) -> Vec<(f64, Option<Angle>)> {
    let step = (frame.to - frame.from) / f64::from(SAMPLES);
    let even = (0..SAMPLES).map(|k| frame.from + step * f64::from(k));
    let all = even.chain([0.1, 0.01, 0.001].map(|part| frame.to - part * step));
    all.map(|degrees| (degrees, Angle::from_degrees(degrees).ok())).collect()
}

/// Distances from the top in even steps of their logarithms.
fn near_top() -> Vec<(f64, Option<Angle>)> {
    let [from, to] = NEAR_TOP.map(f64::ln);
    let logarithms = (0..=SAMPLES).map(|k| from + (to - from) * f64::from(k) / f64::from(SAMPLES));
    let distances = logarithms.map(f64::exp);
    distances.map(|degrees| (degrees, Angle::from_complement(degrees.to_radians()).ok())).collect()
}
