//! Curves cut to the frame of their axes.

use crate::chart::{Panel, Point, Series};
use crate::scene::Place;

/// The pieces of a curve inside the frame, in fractions of the axes; points that are not numbers leave gaps.
pub fn visible_pieces(series: &Series, panel: &Panel) -> Vec<Vec<Place>> {
    let places: Vec<Place> = series.points.iter().map(|point| position(point, panel)).collect();
    let mut pieces: Vec<Vec<Place>> = vec![];
    for pair in places.windows(2) {
        let Some((start, end)) = visible_part(pair[0], pair[1]) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&start) => piece.push(end),
            _ => pieces.push(vec![start, end]),
        }
    }
    pieces
}

/// The position of a point, in fractions of the axes.
pub(crate) fn position(point: &Point, panel: &Panel) -> Place {
    (panel.x.part(point.x), panel.y.part(point.y))
}

/// Returns `true` if a point lies within the frame.
pub(crate) fn is_visible(point: &Point, panel: &Panel) -> bool {
    (panel.x.from..=panel.x.to).contains(&point.x) && (panel.y.from..=panel.y.to).contains(&point.y)
}

/// The part of a segment inside the frame, by Liang and Barsky's method.
fn visible_part(a: Place, b: Place) -> Option<(Place, Place)> {
    if ![a.0, a.1, b.0, b.1].iter().all(|value| value.is_finite()) {
        return None;
    }
    let (x, y) = (part_within(a.0, b.0)?, part_within(a.1, b.1)?);
    let (start, end) = (x.0.max(y.0).max(0.0), x.1.min(y.1).min(1.0));
    (start < end).then(|| (along(a, b, start), along(a, b, end)))
}

/// The range of the parameter (0 at `from`, 1 at `to`) for which the coordinate lies between 0 and 1.
fn part_within(from: f64, to: f64) -> Option<(f64, f64)> {
    if from.max(to) < 0.0 || from.min(to) > 1.0 {
        return None;
    }
    let step = to - from;
    if step.abs() < f64::MIN_POSITIVE {
        return Some((0.0, 1.0));
    }
    let (first, second) = (-from / step, (1.0 - from) / step);
    Some((first.min(second), first.max(second)))
}

/// The point at this parameter. The ends are exact, so that neighbouring pieces meet.
fn along(a: Place, b: Place, parameter: f64) -> Place {
    if parameter <= 0.0 {
        a
    } else if parameter >= 1.0 {
        b
    } else {
        (a.0 + parameter * (b.0 - a.0), a.1 + parameter * (b.1 - a.1))
    }
}
