//! Backbones: amplitude, upwards, against frequency.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::range::around;
use super::style;
use libration::comparison::{Backbone, BackbonePoint};
use libration::quantity::Displacement;

/// The setting of the picture.
pub(crate) struct BackboneSetting {
    pub(crate) title: String,
    pub(crate) order: usize,
    pub(crate) is_angle: bool,
}

/// Amplitudes up to the largest requested one, close enough that curves through them are smooth.
pub(crate) fn amplitudes_of_curves(points: &[BackbonePoint]) -> Vec<Displacement> {
    const SAMPLES: u32 = 240;
    let part = |step: u32| largest(points) * f64::from(step) / f64::from(SAMPLES);
    (1..=SAMPLES).filter_map(|step| Displacement::from_f64(part(step))).collect()
}

fn largest(points: &[BackbonePoint]) -> f64 {
    points.iter().map(|point| point.amplitude).fold(0.0, f64::max)
}

/// Fraction of the range of the orbits up to which the series is drawn beyond them.
const BEYOND: f64 = 0.5;

/// Orbits as markers at the amplitudes requested, on a curve of orbits through the sampled points, with the series and its radius of
/// convergence.
pub(crate) fn backbone(
    curve: &Backbone,
    points: &[BackbonePoint],
    sampled: &[BackbonePoint],
    setting: &BackboneSetting,
) -> Picture {
    let unit = if setting.is_angle { 1_f64.to_degrees() } else { 1.0 };
    let largest = largest(points);
    let orbit = |point: &BackbonePoint| Some((point.orbit.as_ref().ok()?.frequency, unit * point.amplitude));
    let start = curve.omega0().map(|omega0| (omega0, 0.0));
    let orbits: Vec<(f64, f64)> = start.into_iter().chain(sampled.iter().filter_map(orbit)).collect();
    let asked: Vec<(f64, f64)> = points.iter().filter_map(orbit).collect();
    let series: Vec<(f64, f64)> = start
        .into_iter()
        .chain(
            sampled
                .iter()
                .filter_map(|point| Some((point.series.as_ref()?.frequency, unit * point.amplitude))),
        )
        .collect();
    let x = frequencies(&orbits);
    let exact = Series::line("orbits", style::curve(0), orbits.iter().copied());
    let mut shown = vec![];
    if !series.is_empty() {
        shown.push(Series::line("", style::curve(0).beneath(), orbits));
        shown.push(Series::line(&format!("series, order {}", setting.order), style::curve(1), series));
    }
    let radius = curve.radius().map(|radius| radius.value()).filter(|radius| *radius <= largest);
    if let Some(radius) = radius {
        let ends = [x.from, x.to].map(|frequency| (frequency, unit * radius));
        shown.push(Series::line("radius of convergence", style::reference(), ends));
    }
    shown.push(Series { look: Look { width: 1.2, ..exact.look }, ..exact });
    shown.push(Series::line("requested amplitudes", style::markers(0), asked));
    let name = if setting.is_angle { "amplitude / degrees" } else { "amplitude" };
    let (_, top) = around([0.0, unit * largest]);
    let y = Axis::linear(name, 0.0, top);
    let y = if setting.is_angle { y.in_units(Units::Degrees) } else { y };
    Picture::new(&format!("Backbone: {}", setting.title), vec![Panel { x, y, series: shown, share: 1.0 }])
}

/// The range of the orbits with a margin for the series.
fn frequencies(orbits: &[(f64, f64)]) -> Axis {
    let (low, high) = around(orbits.iter().map(|(frequency, _)| *frequency));
    let low = if low > 0.0 && low < BEYOND * (high - low) { 0.0 } else { low.max(0.0) };
    Axis::linear("frequency Ω / (rad per unit of time)", low, high)
}
