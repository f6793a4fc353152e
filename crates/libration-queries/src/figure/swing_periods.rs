//! The exact period against the amplitude, with the amplitudes of a query.

use super::chart::{Axis, Panel, Picture, Point, Series, Units};
use super::range::around;
use super::style;
use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;

const SAMPLES: u32 = 400;

/// The curve from rest, and a marker at each amplitude; `points` has amplitudes and periods, in degrees and s.
pub(crate) fn swing_periods(pendulum: &Pendulum, points: Vec<Point>) -> Picture {
    let (_, to) = around(points.iter().map(|point| point.x).chain([0.0]));
    let to = to.min(180.0);
    let period = |degrees: f64| {
        let amplitude = Angle::from_degrees(degrees).ok().and_then(|angle| Amplitude::new(angle).ok());
        amplitude.map_or(f64::INFINITY, |amplitude| pendulum.swing_period(&amplitude).period)
    };
    let even = (0..=SAMPLES).map(|step| to * f64::from(step) / f64::from(SAMPLES));
    let curve =
        Series::line("exact period", style::exact_law(), even.map(|degrees| (degrees, period(degrees))));
    let small = pendulum.small_angle_period();
    let (low, high) = around(points.iter().map(|point| point.y).chain([small]));
    let small = Series::line("small-angle period T₀", style::reference(), [(0.0, small), (to, small)]);
    let markers = Series { label: String::new(), look: style::measurements(points.len()), points };
    let panel = Panel {
        x: Axis::linear("amplitude θ₀ / degrees", 0.0, to).in_units(Units::Degrees),
        y: Axis::linear("period T / s", low, high),
        series: vec![small, curve, markers],
        share: 1.0,
    };
    Picture::new("Period against amplitude", vec![panel])
}
