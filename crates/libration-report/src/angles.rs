//! Pictures with their angles in degrees or in radians.

use crate::chart::{Axis, Panel, Picture, Point, Scale, Units};
use std::f64::consts::PI;

/// Ends of the labels of axes with angles.
const DEGREES: &str = " / degrees";
const RADIANS: &str = " / rad";

/// The names of half a turn along an axis.
#[derive(Clone, Copy)]
struct Target {
    half_turn: f64,
    end: &'static str,
}

impl Picture {
    /// The picture with the angles of its axes in radians; `None` if it has none.
    pub fn in_radians(&self) -> Option<Self> {
        self.with_angles(Target { half_turn: PI, end: RADIANS })
    }

    /// The picture with the angles of its axes in degrees; `None` if it has none.
    pub fn in_degrees(&self) -> Option<Self> {
        self.with_angles(Target { half_turn: 180.0, end: DEGREES })
    }

    fn with_angles(&self, target: Target) -> Option<Self> {
        let factors: Vec<[Option<f64>; 2]> = self
            .panels
            .iter()
            .enumerate()
            .map(|(number, panel)| {
                // A panel without a label has the axis of the panel below.
                let below = self.panels.get(number + 1).filter(|_| panel.x.label.is_empty());
                let x = half_turn(&panel.x).or_else(|| half_turn(&below?.x));
                [x, half_turn(&panel.y)].map(|half_turn| Some(target.half_turn / half_turn?))
            })
            .collect();
        factors.iter().flatten().any(Option::is_some).then(|| {
            let mut picture = self.clone();
            for (panel, factors) in picture.panels.iter_mut().zip(&factors) {
                convert(panel, *factors, target);
            }
            for dot in picture.animation.iter_mut().flat_map(|animation| &mut animation.dots) {
                let [x, y] = factors[dot.panel].map(|factor| factor.unwrap_or(1.0));
                dot.places.iter_mut().for_each(|position| *position = (x * position.0, y * position.1));
            }
            picture
        })
    }
}

/// Half a turn in the unit of the axis, if it is one of angles.
fn half_turn(axis: &Axis) -> Option<f64> {
    match axis.units {
        Units::Degrees => Some(180.0),
        Units::HalfTurns(half_turn) => Some(half_turn),
        _ if axis.label.ends_with(DEGREES) => Some(180.0),
        _ if axis.label.ends_with(RADIANS) => Some(PI),
        _ => None,
    }
}

fn convert(panel: &mut Panel, factors: [Option<f64>; 2], target: Target) {
    for (axis, factor) in [&mut panel.x, &mut panel.y].into_iter().zip(factors) {
        if let Some(factor) = factor {
            convert_axis(axis, factor, target);
        }
    }
    let [x, y] = factors.map(|factor| factor.unwrap_or(1.0));
    for point in panel.series.iter_mut().flat_map(|series| &mut series.points) {
        *point = Point {
            x: x * point.x,
            y: y * point.y,
            x_uncertainty: point.x_uncertainty.map(|uncertainty| x * uncertainty),
            y_uncertainty: point.y_uncertainty.map(|uncertainty| y * uncertainty),
        };
    }
}

fn convert_axis(axis: &mut Axis, factor: f64, target: Target) {
    (axis.from, axis.to) = (factor * axis.from, factor * axis.to);
    let name = axis.label.strip_suffix(DEGREES).or_else(|| axis.label.strip_suffix(RADIANS));
    if let Some(name) = name {
        axis.label = format!("{name}{}", target.end);
    }
    let is_of_angles = matches!(axis.units, Units::Degrees | Units::HalfTurns(_));
    if is_of_angles && matches!(axis.scale, Scale::Linear) {
        let is_degrees = target.end == DEGREES;
        axis.units = if is_degrees { Units::Degrees } else { Units::HalfTurns(target.half_turn) };
    }
}
