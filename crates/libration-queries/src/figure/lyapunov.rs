//! Convergence of the estimate of a Lyapunov exponent with the time measured.

use super::chart::{Axis, Panel, Picture, Series};
use super::names::name;
use super::parameters::{self, AngleUnit, of_model, of_start};
use super::range::around;
use super::style;
use libration::chaos::LyapunovExponent;
use libration::quantity::Quantity;
use libration::systems::Model;

/// The space left free before the first time and after the last, as a ratio.
const ROOM: f64 = 1.1;

/// The estimate against the time, on a logarithmic axis.
pub(crate) fn convergence(model: &Model, start: &[f64], exponent: &LyapunovExponent) -> Picture {
    let points = &exponent.convergence;
    let times = || points.iter().map(|(time, _)| *time);
    let (first, last) = (times().fold(f64::INFINITY, f64::min), times().fold(0.0, f64::max));
    let x = Axis::logarithmic("time measured / s", first / ROOM, last * ROOM);
    let (low, high) = around(points.iter().map(|(_, estimate)| *estimate).chain([0.0]));
    let y = Axis::linear("largest Lyapunov exponent / (1/s)", low, high);
    let zero = Series::line("", style::reference(), [(x.from, 0.0), (x.to, 0.0)]);
    let line = Series::line("", style::curve(0), points.iter().copied());
    let title = format!("Largest Lyapunov exponent: {}, {}", name(model), exponent.verdict);
    let value = Quantity { value: exponent.exponent, uncertainty: Some(exponent.uncertainty) };
    let made_with = [of_model(model), of_start(model, start, AngleUnit::Degrees)].concat();
    let picture = Picture::new(&title, vec![Panel { x, y, series: vec![zero, line], share: 1.0 }]);
    picture.with_parameters(made_with.into_iter().chain([parameters::estimate("λ", value, "1/s")]))
}
