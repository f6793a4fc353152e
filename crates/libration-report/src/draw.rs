//! A picture as a scene.

use crate::animation;
use crate::chart::{Panel, Picture};
use crate::curve_names::{self, Curve};
use crate::describe;
use crate::format::{PictureFormat, TooSmall};
use crate::frame::{Cell, Frame, NAME_GAP, PADDING, TICK_BASE, TICK_GAP, TITLE};
use crate::letters::{ASCENT, LINE, width};
use crate::marks;
use crate::scene::{Anchor, Form, Place, Scene, Shape, ShapeRole, Text};
use crate::style::INK;

/// Lengths of ticks, in units of the letter size.
const LONG_TICK: f64 = 0.35;
const SHORT_TICK: f64 = 0.2;
/// Widths of lines of the axes.
const FRAME_LINE: f64 = 0.07;
const TICK_LINE: f64 = 0.055;
/// Distance from the middle of digits to their base line.
const HALF_DIGIT: f64 = 0.365;

/// Lays the picture out in a format.
///
/// # Errors
///
/// [`TooSmall`] if the format cannot hold the axes with their labels.
pub fn draw(picture: &Picture, format: &PictureFormat) -> Result<Scene, TooSmall> {
    let em = format.text;
    let mut named = if format.names_curves { curve_names::candidates(picture) } else { vec![] };
    loop {
        // The legend has the other names, and its height decides where the axes are.
        let laid_out = curve_names::above_axes(picture, &named, format.has_title);
        let frame = Frame::new(&laid_out, format)?;
        let names = curve_names::placed(picture, &frame, em, &named);
        if names.len() == named.len() {
            return Ok(scene(picture, &laid_out, &frame, format, names));
        }
        named = names.into_iter().map(|(curve, _)| curve).collect();
    }
}

/// The scene of a picture; `laid_out` has the texts that are above the axes.
fn scene(
    picture: &Picture,
    laid_out: &Picture,
    frame: &Frame,
    format: &PictureFormat,
    names: Vec<(Curve, Shape)>,
) -> Scene {
    let em = format.text;
    let mut panels: Vec<Vec<Shape>> = picture
        .panels
        .iter()
        .zip(&frame.cells)
        .map(|(panel, cell)| of_panel(panel, cell, frame, em))
        .collect();
    for (curve, name) in names {
        panels[curve.panel].push(name);
    }
    Scene {
        width: format.width,
        height: frame.height * em,
        title: picture.title.clone(),
        description: describe::picture(picture),
        words: words(laid_out, frame, em),
        panels,
        moving: animation::moving(picture, frame, em),
        seconds: picture.animation.as_ref().map_or(0.0, |animation| animation.seconds),
    }
}

/// Title, parameters and legends.
fn words(picture: &Picture, frame: &Frame, em: f64) -> Vec<Shape> {
    let mut shapes = vec![];
    let mut top = PADDING;
    for (role, size, lines) in
        [(ShapeRole::Title, TITLE, &frame.title), (ShapeRole::Parameters, 1.0, &frame.parameters)]
    {
        for line in lines {
            let at = (PADDING * em, (top + (0.5 * (LINE - 1.0) + ASCENT) * size) * em);
            shapes.push(text(role, line, at, Anchor::Start, size * em));
            top += LINE * size;
        }
    }
    for (panel, cell) in picture.panels.iter().zip(&frame.cells) {
        shapes.extend(cell.legend.shapes(panel, (PADDING * em, cell.legend_top * em), em));
    }
    shapes
}

fn of_panel(panel: &Panel, cell: &Cell, frame: &Frame, em: f64) -> Vec<Shape> {
    let on_canvas = |parts: Place| frame.position(cell, parts, em);
    let mut shapes: Vec<Shape> = vec![];
    shapes.extend(panel.series.iter().flat_map(|series| marks::of_series(series, panel, em, &on_canvas)));
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)].map(on_canvas).to_vec();
    shapes.push(lines(ShapeRole::Frame, vec![corners], FRAME_LINE * em));
    shapes.push(lines(ShapeRole::Tick, ticks(cell, em, &on_canvas), TICK_LINE * em));
    shapes.extend(tick_labels(cell, em, &on_canvas));
    shapes.extend(names(cell, frame, em));
    shapes
}

/// The ticks on all four sides.
fn ticks(cell: &Cell, em: f64, on_canvas: &dyn Fn(Place) -> Place) -> Vec<Vec<Place>> {
    let across = |part: f64, length: f64| {
        let ((x, bottom), (_, top)) = (on_canvas((part, 0.0)), on_canvas((part, 1.0)));
        [vec![(x, bottom), (x, bottom - length * em)], vec![(x, top), (x, top + length * em)]]
    };
    let up = |part: f64, length: f64| {
        let ((left, y), (right, _)) = (on_canvas((0.0, part)), on_canvas((1.0, part)));
        [vec![(left, y), (left + length * em, y)], vec![(right, y), (right - length * em, y)]]
    };
    let of = |ticks: &crate::ticks::Ticks, side: &dyn Fn(f64, f64) -> [Vec<Place>; 2]| -> Vec<Vec<Place>> {
        let long = ticks.labelled.iter().map(|(part, _)| (*part, LONG_TICK));
        let short = ticks.minor.iter().map(|part| (*part, SHORT_TICK));
        long.chain(short).flat_map(|(part, length)| side(part, length)).collect()
    };
    [of(&cell.x_ticks, &across), of(&cell.y_ticks, &up)].concat()
}

fn tick_labels(cell: &Cell, em: f64, on_canvas: &dyn Fn(Place) -> Place) -> Vec<Shape> {
    let below = cell.x_ticks.labelled.iter().filter(|_| cell.has_x_labels).map(|(part, label)| {
        let (x, y) = on_canvas((*part, 0.0));
        text(ShapeRole::XTickLabel, label, (x, y + TICK_BASE * em), Anchor::Middle, em)
    });
    let beside = cell.y_ticks.labelled.iter().map(|(part, label)| {
        let (x, y) = on_canvas((0.0, *part));
        text(ShapeRole::YTickLabel, label, (x - TICK_GAP * em, y + HALF_DIGIT * em), Anchor::End, em)
    });
    below.chain(beside).collect()
}

/// The labels of the axes, at the middle of each axis as far as the canvas has room.
fn names(cell: &Cell, frame: &Frame, em: f64) -> Vec<Shape> {
    let mut shapes = vec![];
    let below = cell.top + cell.height + if cell.has_x_labels { TICK_BASE + 0.25 } else { 0.35 };
    for (line, name) in (0_u32..).zip(&cell.x_name) {
        let half = 0.5 * width(name, 1.0);
        let middle = (0.5 * (frame.left + frame.right)).min(frame.width - PADDING - half).max(PADDING + half);
        let base = below + LINE * f64::from(line) + 0.5 * (LINE - 1.0) + ASCENT;
        shapes.push(text(ShapeRole::AxisLabel, name, (middle * em, base * em), Anchor::Middle, em));
    }
    let widest = cell.y_ticks.labelled.iter().map(|(_, label)| width(label, 1.0)).fold(0.0, f64::max);
    let lines: f64 = cell.y_name.iter().map(|_| LINE).sum();
    let first = frame.left - TICK_GAP - widest - NAME_GAP - lines;
    for (line, name) in (0_u32..).zip(&cell.y_name) {
        let base = first.max(PADDING) + LINE * f64::from(line) + ASCENT + 0.1;
        let at = (base * em, (cell.top + 0.5 * cell.height) * em);
        let Form::Text(written) = text(ShapeRole::AxisLabel, name, at, Anchor::Middle, em).form else {
            continue;
        };
        let turned = Form::Text(Text { is_turned: true, ..written });
        shapes.push(Shape { role: ShapeRole::AxisLabel, form: turned, colour: INK, opacity: 1.0 });
    }
    shapes
}

fn text(role: ShapeRole, content: &str, at: Place, anchor: Anchor, size: f64) -> Shape {
    let text = Text { content: content.to_owned(), at, anchor, size, is_turned: false };
    Shape { role, form: Form::Text(text), colour: INK, opacity: 1.0 }
}

fn lines(role: ShapeRole, pieces: Vec<Vec<Place>>, width: f64) -> Shape {
    Shape { role, form: Form::Lines { pieces, width, dashes: vec![] }, colour: INK, opacity: 1.0 }
}
