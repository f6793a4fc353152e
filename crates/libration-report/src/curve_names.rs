//! Names next to their curves.
//!
//! # Method
//! At points along a curve, the name is tried on both sides, at a fixed distance from the point along the normal of the curve. A position is
//! possible if the name lies within the axes, on no curve, marker or other name, and is nearer to its own curve than to any other. The one
//! that is farthest from all others is taken; a curve without a possible position keeps its entry in the legend.

use crate::chart::{Mark, Panel, Picture, Series};
use crate::clip;
use crate::frame::{Cell, Frame};
use crate::letters::{ASCENT, width};
use crate::scene::{Anchor, Form, Place, Shape, ShapeRole, Text};
use crate::style::INK;

/// Points that are tried along a curve.
const TRIED: u32 = 60;
/// All lengths below are in units of the letter size. Gap between a name and its curve:
const GAP: f64 = 0.35;
/// Least gap between a name and other curves and names: larger than the gap to its own curve, which is then the nearest one.
const APART: f64 = 1.5 * GAP;
/// Gap between a name and the frame, which hides the ticks.
const MARGIN: f64 = 0.5;
/// Distance to other curves from which more makes no difference.
const FAR: f64 = 3.0;
/// Height of a name.
const HEIGHT: f64 = 1.0;

/// A curve of a picture by its panel and its place among the panel's series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Curve {
    pub(crate) panel: usize,
    series: usize,
}

/// The curves that have a name.
pub(crate) fn candidates(picture: &Picture) -> Vec<Curve> {
    let of_panel = |(panel, content): (usize, &Panel)| {
        let named = |series: &Series| !series.label.is_empty() && matches!(series.look.mark, Mark::Line(_));
        let curves = content.series.iter().enumerate().filter(|(_, series)| named(series));
        curves.map(|(series, _)| Curve { panel, series }).collect::<Vec<_>>()
    };
    picture.panels.iter().enumerate().flat_map(of_panel).collect()
}

/// The picture with the texts that stand above its axes: without the names at curves and those that a panel above explains, and without title
/// and parameters if it has none.
pub(crate) fn above_axes(picture: &Picture, named: &[Curve], has_title: bool) -> Picture {
    let mut words = picture.clone();
    if !has_title {
        (words.title, words.parameters) = (String::new(), vec![]);
    }
    for (panel, content) in words.panels.iter_mut().enumerate() {
        for (series, entry) in content.series.iter_mut().enumerate() {
            let is_same = |other: &Series| other.label == entry.label && other.look == entry.look;
            let is_explained = picture.panels[..panel].iter().flat_map(|above| &above.series).any(is_same);
            if is_explained || named.contains(&Curve { panel, series }) {
                entry.label.clear();
            }
        }
    }
    words
}

/// The names that have a position, as shapes.
pub(crate) fn placed(picture: &Picture, frame: &Frame, em: f64, named: &[Curve]) -> Vec<(Curve, Shape)> {
    let mut placed = vec![];
    for (number, (panel, cell)) in picture.panels.iter().zip(&frame.cells).enumerate() {
        let outlines: Vec<Vec<Vec<Place>>> =
            panel.series.iter().map(|series| outline(series, panel, cell, frame)).collect();
        let mut taken: Vec<Rectangle> = vec![];
        for curve in named.iter().filter(|curve| curve.panel == number) {
            let name = &panel.series[curve.series].label;
            let Some(rectangle) = position(name, curve.series, &outlines, &taken, cell, frame) else {
                continue;
            };
            placed.push((*curve, text(name, rectangle, em)));
            taken.push(rectangle);
        }
    }
    placed
}

/// The visible lines of a series, or its markers as lines of one point, in units of the letter size.
fn outline(series: &Series, panel: &Panel, cell: &Cell, frame: &Frame) -> Vec<Vec<Place>> {
    let on_canvas = |parts: Place| frame.position(cell, parts, 1.0);
    match series.look.mark {
        Mark::Line(_) => {
            let pieces = clip::visible_pieces(series, panel).into_iter();
            pieces.map(|piece| piece.into_iter().map(on_canvas).collect()).collect()
        }
        Mark::Markers(_) => {
            let shown = series.points.iter().filter(|point| clip::is_visible(point, panel));
            shown.map(|point| vec![on_canvas(clip::position(point, panel))]).collect()
        }
        Mark::Band => vec![],
    }
}

fn position(
    name: &str,
    index: usize,
    outlines: &[Vec<Vec<Place>>],
    taken: &[Rectangle],
    cell: &Cell,
    frame: &Frame,
) -> Option<Rectangle> {
    let inside = Rectangle {
        middle: (f64::midpoint(frame.left, frame.right), cell.top + 0.5 * cell.height),
        half: (0.5 * (frame.right - frame.left) - MARGIN, 0.5 * cell.height - MARGIN),
    };
    let half = (0.5 * width(name, 1.0), 0.5 * HEIGHT);
    let tried = outlines[index].iter().flat_map(|piece| along(piece)).flat_map(|(at, normal)| {
        let away = half.0 * normal.0.abs() + half.1 * normal.1.abs() + GAP;
        [away, -away].map(|away| Rectangle { middle: (at.0 + away * normal.0, at.1 + away * normal.1), half })
    });
    let possible = tried.filter(|rectangle| {
        inside.holds(rectangle)
            && taken.iter().all(|other| rectangle.gap(other) >= APART)
            && outlines[index].iter().all(|piece| rectangle.distance(piece, FAR) >= 0.5 * GAP)
    });
    let others = || outlines.iter().enumerate().filter(|(series, _)| *series != index);
    let rated = possible.map(|rectangle| {
        let distances = others().flat_map(|(_, pieces)| pieces).map(|piece| rectangle.distance(piece, FAR));
        (distances.fold(FAR, f64::min), rectangle)
    });
    rated.filter(|(apart, _)| *apart >= APART).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, best)| best)
}

/// Points at even distances along a line, with the normal there.
fn along(piece: &[Place]) -> Vec<(Place, Place)> {
    let lengths: Vec<f64> = piece.windows(2).map(|pair| length(pair[0], pair[1])).collect();
    let step = lengths.iter().sum::<f64>() / f64::from(TRIED);
    let (mut points, mut passed, mut next) = (vec![], 0.0, 0.5 * step);
    for (pair, length) in piece.windows(2).zip(lengths) {
        while length > 0.0 && next <= passed + length {
            let part = (next - passed) / length;
            let (dx, dy) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            points.push(((pair[0].0 + part * dx, pair[0].1 + part * dy), (-dy / length, dx / length)));
            next += step;
        }
        passed += length;
    }
    points
}

fn length(from: Place, to: Place) -> f64 {
    (to.0 - from.0).hypot(to.1 - from.1)
}

fn text(name: &str, rectangle: Rectangle, em: f64) -> Shape {
    let (x, y) = rectangle.middle;
    let at = (x * em, (y + 0.5 * ASCENT) * em);
    let text = Text { content: name.to_owned(), at, anchor: Anchor::Middle, size: em, is_turned: false };
    Shape { role: ShapeRole::Name, form: Form::Text(text), colour: INK, opacity: 1.0 }
}

/// A rectangle with level sides.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    middle: Place,
    /// Half of the width and of the height.
    half: Place,
}

impl Rectangle {
    fn holds(&self, other: &Self) -> bool {
        (other.middle.0 - self.middle.0).abs() + other.half.0 <= self.half.0
            && (other.middle.1 - self.middle.1).abs() + other.half.1 <= self.half.1
    }

    /// The distance to another rectangle.
    fn gap(&self, other: &Self) -> f64 {
        let x = (other.middle.0 - self.middle.0).abs() - self.half.0 - other.half.0;
        let y = (other.middle.1 - self.middle.1).abs() - self.half.1 - other.half.1;
        x.max(0.0).hypot(y.max(0.0))
    }

    /// The distance to a line, at most `most`: between neighbouring points it is taken at the end of steps of a quarter of the gap.
    fn distance(&self, line: &[Place], most: f64) -> f64 {
        let mut least = line.first().map_or(most, |point| self.distance_to(*point).min(most));
        for pair in line.windows(2) {
            let steps = (length(pair[0], pair[1]) / (0.25 * GAP)).ceil().max(1.0);
            // A line that is far away stays far away over its length.
            if self.distance_to(pair[0]) - length(pair[0], pair[1]) >= least {
                continue;
            }
            let mut step = 1.0;
            while step <= steps {
                let part = step / steps;
                let at =
                    (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1));
                least = least.min(self.distance_to(at));
                step += 1.0;
            }
        }
        least
    }

    fn distance_to(&self, (x, y): Place) -> f64 {
        let x = ((x - self.middle.0).abs() - self.half.0).max(0.0);
        let y = ((y - self.middle.1).abs() - self.half.1).max(0.0);
        x.hypot(y)
    }
}
