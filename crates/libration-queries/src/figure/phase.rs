//! The phase portrait: librations about each bottom, the separatrix, and rotations both ways.

use super::chart::{Axis, Look, Panel, Picture, Series, Units};
use super::style;
use libration::pendulum::Motion;
use std::f64::consts::{PI, TAU};

const SAMPLES: u32 = 400;

/// A motion of a pendulum with ω0 = 1 that passes the bottom with positive velocity at t = 0, with its label.
pub(crate) struct Orbit {
    pub(crate) label: String,
    pub(crate) motion: Motion,
}

/// The orbits of the portrait.
pub(crate) struct Portrait {
    pub(crate) librations: Vec<Orbit>,
    pub(crate) separatrix: Motion,
    pub(crate) rotations: Vec<Orbit>,
}

/// The portrait over two turns, −2π ≤ θ ≤ 2π; velocities in units of ω0.
pub(crate) fn portrait(portrait: &Portrait) -> Picture {
    let mut series = vec![];
    for (number, orbit) in portrait.librations.iter().enumerate() {
        let points = path(&orbit.motion, 0.0, orbit.motion.period());
        series.extend(repeated(&orbit.label, &style::curve(number), &points));
    }
    // Twelve units of time from the bottom the distance to the top is 2e-5, less than a line's width.
    let half = path(&portrait.separatrix, -12.0, 12.0);
    series.extend(both_ways("separatrix", &style::separatrix(), &half));
    for (number, orbit) in portrait.rotations.iter().enumerate() {
        let turn = 0.5 * orbit.motion.period();
        let points = path(&orbit.motion, -turn, turn);
        series.extend(both_ways(&orbit.label, &style::curve(number + portrait.librations.len()), &points));
    }
    let highest = series.iter().flat_map(|series| &series.points).map(|point| point.y).fold(0.0, f64::max);
    let top = (2.0 * highest + 0.6).floor() / 2.0 + 0.5;
    let x = Axis::linear("angle θ / rad", -2.0, 2.0).in_units(Units::HalfTurns(1.0));
    let y = Axis::linear("velocity θ′ / ω₀", -top, top);
    Picture::new("Phase portrait of the pendulum", vec![Panel { x, y, series, share: 1.0 }])
}

/// Angle (in units of π) and velocity along a motion.
fn path(motion: &Motion, from: f64, to: f64) -> Vec<(f64, f64)> {
    let time = |step| from + (to - from) * f64::from(step) / f64::from(SAMPLES);
    let point = |step| {
        let state = motion.state_at(time(step));
        (state.angle / PI, state.velocity)
    };
    (0..=SAMPLES).map(point).collect()
}

/// The curve about each of the three bottoms in view; only the first has a legend entry.
fn repeated<'a>(
    label: &'a str,
    look: &'a Look,
    points: &'a [(f64, f64)],
) -> impl Iterator<Item = Series> + 'a {
    let labels = [label, "", ""];
    labels.into_iter().zip([0.0, -TAU / PI, TAU / PI]).map(move |(label, shift)| {
        Series::line(label, look.clone(), points.iter().map(|(angle, velocity)| (angle + shift, *velocity)))
    })
}

/// The same curve for motions in both directions.
fn both_ways<'a>(label: &'a str, look: &'a Look, points: &[(f64, f64)]) -> Vec<Series> {
    let back: Vec<(f64, f64)> = points.iter().map(|(angle, velocity)| (-angle, -velocity)).collect();
    repeated(label, look, points).chain(repeated("", look, &back)).collect()
}
