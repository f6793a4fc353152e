//! Frequency of a normal mode against its amplitude: stable orbits solid, unstable ones dashed, with the series for small amplitudes.

use super::chart::{Axis, Look, Mark, Panel, Picture, Series, Units};
use super::names::{subject, symbol};
use super::parameters::of_model;
use super::range::around;
use super::style;
use libration::nonlinear_modes::{ModePoint, NonlinearMode};
use libration::systems::Model;

/// The dashes of unstable parts.
const DASHES: &[f64] = &[5.0, 4.0];

/// Frequency against amplitude, angles in degrees.
pub(crate) fn backbone(model: &Model, mode: usize, coordinate: usize, family: &NonlinearMode) -> Picture {
    let coordinate = &model.coordinates()[coordinate];
    let unit = if coordinate.is_angle() { 1_f64.to_degrees() } else { 1.0 };
    let position = |point: &ModePoint| (unit * point.amplitude, point.orbit.frequency());
    let mut series = vec![];
    let small =
        family.points.iter().filter_map(|point| Some((unit * point.amplitude, point.series_frequency?)));
    let small: Vec<(f64, f64)> = small.collect();
    if !small.is_empty() {
        series.push(Series::line("ω + κa²", style::reference(), small));
    }
    let mut named = [false; 2];
    for stretch in family.points.chunk_by(|a, b| a.is_stable() == b.is_stable()) {
        let stable = stretch[0].is_stable();
        let first = !std::mem::replace(&mut named[usize::from(stable)], true);
        let label = if stable { "stable" } else { "unstable" };
        let label = if first { label } else { "" };
        series.push(Series::line(label, look(stable), stretch.iter().map(position)));
        series.push(Series::line("", style::markers(usize::from(!stable)), stretch.iter().map(position)));
    }
    // The series leaves the frame where it is far off.
    let (low, high) = around(family.points.iter().map(|point| point.orbit.frequency()));
    let last = family.points.last().map_or(1.0, |point| unit * point.amplitude);
    let degrees = if coordinate.is_angle() { " / degrees" } else { "" };
    let x = Axis::linear(&format!("amplitude of {}{degrees}", symbol(&coordinate.name)), 0.0, 1.05 * last);
    let x = if coordinate.is_angle() { x.in_units(Units::Degrees) } else { x };
    let y = Axis::linear("frequency / (rad/s)", low, high);
    let title = format!("Mode {} of {}", mode + 1, subject(model));
    Picture::new(&title, vec![Panel { x, y, series, share: 1.0 }]).with_parameters(of_model(model))
}

fn look(stable: bool) -> Look {
    let line = style::curve(usize::from(!stable));
    if stable { line } else { Look { mark: Mark::Line(DASHES), ..line } }
}
