//! Curves cut to the frame of their axes, since the drawing library draws over it.

use super::chart::{Axis, Point, Series};

/// The pieces of a curve that lie within the frame; gaps at points that are not numbers.
pub(crate) fn visible_pieces(series: &Series, x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = vec![];
    let mut piece = vec![];
    for pair in series.points.windows(2) {
        match visible_part(pair[0], pair[1], x, y) {
            Some((start, end)) => {
                if piece.last() != Some(&start) {
                    flush(&mut piece, &mut pieces);
                    piece.push(start);
                }
                piece.push(end);
            }
            None => flush(&mut piece, &mut pieces),
        }
    }
    flush(&mut piece, &mut pieces);
    pieces
}

/// Whether a point lies within the frame.
pub(crate) fn is_visible(point: &Point, x: &Axis, y: &Axis) -> bool {
    (x.from..=x.to).contains(&point.x) && (y.from..=y.to).contains(&point.y)
}

fn flush(piece: &mut Vec<(f64, f64)>, pieces: &mut Vec<Vec<(f64, f64)>>) {
    if piece.len() > 1 {
        pieces.push(std::mem::take(piece));
    }
    piece.clear();
}

/// The part of a segment inside the frame, by Liang and Barsky's method in the evenly divided coordinates.
fn visible_part(a: Point, b: Point, x: &Axis, y: &Axis) -> Option<((f64, f64), (f64, f64))> {
    if ![a.x, a.y, b.x, b.y].iter().all(|value| value.is_finite()) {
        return None;
    }
    let (mut start, mut end) = (0.0, 1.0);
    for (axis, from, to) in [(x, a.x, b.x), (y, a.y, b.y)] {
        let (low, high) = part_between(axis, axis.coordinate(from), axis.coordinate(to))?;
        start = low.max(start);
        end = high.min(end);
    }
    (start < end).then(|| (along(a, b, x, y, start), along(a, b, x, y, end)))
}

/// The range of the parameter for which the coordinate lies within the axis.
fn part_between(axis: &Axis, from: f64, to: f64) -> Option<(f64, f64)> {
    let (low, high) = (axis.coordinate(axis.from), axis.coordinate(axis.to));
    if from.max(to) < low || from.min(to) > high {
        return None;
    }
    let step = to - from;
    if step == 0.0 {
        return Some((0.0, 1.0));
    }
    let (first, second) = ((low - from) / step, (high - from) / step);
    Some((first.min(second), first.max(second)))
}

fn along(a: Point, b: Point, x: &Axis, y: &Axis, parameter: f64) -> (f64, f64) {
    match parameter {
        0.0 => (a.x, a.y),
        1.0 => (b.x, b.y),
        _ => (between(x, a.x, b.x, parameter), between(y, a.y, b.y, parameter)),
    }
}

fn between(axis: &Axis, from: f64, to: f64, parameter: f64) -> f64 {
    let (from, to) = (axis.coordinate(from), axis.coordinate(to));
    let coordinate = (to - from).mul_add(parameter, from);
    match axis.scale {
        super::chart::Scale::Linear => coordinate,
        super::chart::Scale::Logarithmic => 10f64.powf(coordinate),
    }
}
