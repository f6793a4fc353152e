//! The Melnikov function over the phase of the drive, and resonances on the curve of frequencies.

use super::chart::{Axis, Panel, Picture, Point, Series, Units};
use super::names::subject;
use super::parameters::{self, of_model};
use super::range::around;
use super::style;
use crate::output::number::count;
use libration::melnikov::{DriveResonance, Melnikov};
use libration::pendulum::{Motion, Pendulum};
use libration::systems::Model;
use std::f64::consts::TAU;

/// Points of a curve.
const PLACES: usize = 240;

/// The content of the picture.
pub(crate) struct Perturbed<'a> {
    pub(crate) model: &'a Model,
    /// A parameter with the value that is shown.
    pub(crate) at: Option<(&'a str, f64)>,
    pub(crate) omega0: f64,
    pub(crate) separatrices: &'a [Melnikov; 2],
    pub(crate) resonances: &'a [DriveResonance],
}

/// Panels one above the other; the second only if there are resonances.
pub(crate) fn melnikov(of: &Perturbed<'_>) -> Picture {
    let mut panels = vec![function(of.separatrices)];
    if !of.resonances.is_empty() {
        panels.extend(resonances(of));
    }
    let title = format!("Melnikov function of {}", subject(of.model));
    let at = of.at.map(|(name, value)| parameters::said(name, value, ""));
    Picture { aspect: 0.5 * count(panels.len()), ..Picture::new(&title, panels) }
        .with_parameters(of_model(of.model).into_iter().chain(at))
}

fn function(separatrices: &[Melnikov; 2]) -> Panel {
    let phases = || (0..=PLACES).map(|j| TAU * count(j) / count(PLACES));
    let mut series = vec![Series::line("", style::reference(), [(0.0, 0.0), (360.0, 0.0)])];
    for (number, (label, melnikov)) in
        ["upper separatrix", "lower separatrix"].iter().zip(separatrices).enumerate()
    {
        let points = phases().map(|phase| (phase.to_degrees(), melnikov.at_phase(phase)));
        series.push(Series::line(label, style::curve(number), points));
        let zeros: Vec<(f64, f64)> =
            melnikov.zeros().iter().map(|(phase, _)| (phase.to_degrees(), 0.0)).collect();
        if !zeros.is_empty() {
            series.push(Series::line("", style::markers(number), zeros));
        }
    }
    let x = Axis::linear("phase of the drive at the bottom / degrees", 0.0, 360.0).in_units(Units::Degrees);
    let (low, high) =
        around(series.iter().flat_map(|one| one.points.iter().map(|point| point.y)).chain([0.0]));
    Panel { x, y: Axis::linear("M / (rad²/s²)", low, high), series, share: 1.0 }
}

/// Frequency against the velocity at the bottom, with bars as wide as the resonances.
fn resonances(of: &Perturbed<'_>) -> Option<Panel> {
    let pendulum = Pendulum::from_angular_frequency(of.omega0).ok()?;
    let speed = |motion: &Motion| (2.0 * motion.specific_energy()).sqrt();
    let sign = |resonance: &DriveResonance| if resonance.direction < 0.0 { -1.0 } else { 1.0 };
    let top = 2.0 * of.omega0;
    let marker = |resonance: &DriveResonance| {
        let speed = speed(&resonance.motion);
        // dE = ω·dJ and E = v²/2.
        let half = resonance.half_width * resonance.motion.frequency() / speed;
        Point {
            x_uncertainty: Some(half),
            ..Point::new(sign(resonance) * speed, resonance.motion.frequency())
        }
    };
    let points: Vec<Point> = of.resonances.iter().map(marker).collect();
    let half = |point: &Point| point.x_uncertainty.unwrap_or(0.0);
    let last = points.iter().map(|point| point.x + half(point)).fold(1.25 * top, f64::max);
    let first = points.iter().map(|point| point.x - half(point) - 0.1 * top).fold(0.0, f64::min);
    let curve = |from: f64, to: f64| {
        let velocities = (0..=PLACES).map(move |j| from + (to - from) * count(j) / count(PLACES));
        velocities.filter_map(|velocity| {
            let motion = pendulum.with_energy_ratio(velocity * velocity / (top * top)).ok()?;
            Some((velocity, motion.frequency()))
        })
    };
    let line = |label: &str, from: f64, to: f64| Series::line(label, style::curve(0), curve(from, to));
    let mut series = vec![line("free motions", 0.0, top), line("", top, last)];
    if first < 0.0 {
        series.push(line("", first.min(-top), -top));
    }
    let high = series.iter().flat_map(|one| one.points.iter().map(|point| point.y)).fold(0.0, f64::max);
    for edge in [-top, top].into_iter().filter(|edge| *edge > first) {
        series.push(Series::line("", style::reference(), [(edge, 0.0), (edge, 1.05 * high)]));
    }
    series
        .push(Series { points, ..Series::line("resonances with their half-widths", style::markers(1), []) });
    let x = Axis::linear("velocity at the bottom / (rad/s)", first, last);
    Some(Panel { x, y: Axis::linear("frequency / (rad/s)", 0.0, 1.05 * high), series, share: 1.0 })
}
