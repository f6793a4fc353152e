//! The legend, to the right of the axes where it hides no data, with samples long enough to show the dashes.

use super::chart::{Mark, Panel, Picture, Series};
use super::frame::Frame;
use super::letters;
use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

const TEXT_SIZE: u32 = 17;
const ROW: f64 = 28.0;
const SAMPLE: f64 = 54.0;
const GAP: f64 = 10.0;
/// From the top of a panel to the middle of the first row.
const FIRST_ROW: f64 = 24.0;

/// The width the legends need beside the axes.
pub(super) fn width(picture: &Picture) -> f64 {
    let labels = picture.panels.iter().flat_map(named);
    let longest = labels.map(|series| letters::width(&series.label, f64::from(TEXT_SIZE))).reduce(f64::max);
    longest.map_or(0.0, |longest| SAMPLE + 3.0 * GAP + longest)
}

/// The height a panel's legend needs.
pub(super) fn height(panel: &Panel) -> f64 {
    FIRST_ROW + named(panel).map(|_| ROW).sum::<f64>()
}

/// Widens the scene and writes each panel's legend into the new space, beside the panel.
pub(super) fn add(scene: &mut Scene, picture: &Picture, frame: &Frame) {
    let left = scene.width;
    for (panel, (top, _)) in picture.panels.iter().zip(&frame.cells) {
        for (row, series) in (0_u32..).zip(named(panel)) {
            entry(scene, series, left, ROW.mul_add(f64::from(row), top + FIRST_ROW));
        }
    }
}

fn named(panel: &Panel) -> impl Iterator<Item = &Series> {
    panel.series.iter().filter(|series| !series.label.is_empty())
}

fn entry(scene: &mut Scene, series: &Series, left: f64, middle: f64) {
    scene.add(sample(series, left, middle));
    scene.add(Primitive::Text {
        x: left + SAMPLE + GAP,
        y: middle + 0.35 * f64::from(TEXT_SIZE),
        content: series.label.clone(),
        size: TEXT_SIZE,
        anchor: TextAnchor::Start,
        rotate: None,
        bold: false,
        color: None,
    });
}

fn sample(series: &Series, left: f64, middle: f64) -> Primitive {
    let colour = Color::from(series.look.colour);
    match series.look.mark {
        Mark::Line(dashes) => Primitive::PolyLine {
            points: vec![(left, middle), (left + SAMPLE, middle)],
            stroke: colour,
            stroke_width: series.look.width,
            stroke_dasharray: (!dashes.is_empty()).then(|| dashes.to_owned()),
        },
        Mark::Markers(number) => marker(number, series.look.width, (left + SAMPLE / 2.0, middle), colour),
    }
}

/// The marker of this number as the drawing library draws it: circle, square, triangle, diamond.
fn marker(number: usize, size: f64, (x, y): (f64, f64), fill: Color) -> Primitive {
    let outline = match number % 4 {
        0 => {
            let (fill_opacity, stroke, stroke_width) = (None, None, None);
            return Primitive::Circle { cx: x, cy: y, r: size, fill, fill_opacity, stroke, stroke_width };
        }
        1 => [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
        2 => [(0.0, -1.02), (0.0, -1.02), (1.0, 0.68), (-1.0, 0.68)],
        _ => [(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)],
    };
    let corners: Vec<String> = outline
        .iter()
        .map(|(dx, dy)| format!("{:.2},{:.2}", size.mul_add(*dx, x), size.mul_add(*dy, y)))
        .collect();
    Primitive::Path(Box::new(PathData {
        d: format!("M{}Z", corners.join("L")),
        stroke: fill.clone(),
        fill: Some(fill),
        stroke_width: 0.0,
        opacity: None,
        stroke_dasharray: None,
    }))
}
