//! Curves, markers, bars and bands as shapes on the canvas.

use crate::chart::{Look, Mark, Panel, Point, Series};
use crate::clip;
use crate::scene::{Form, Place, Shape, ShapeRole};

/// The letter size to which widths of lines refer.
const USUAL_LETTER: f64 = 16.0;
/// Least half-width of a marker in a legend.
const LEAST_SAMPLE: f64 = 3.0;
/// Half the length of the caps of an error bar.
const CAP: f64 = 0.18;

/// The shapes of a series; `on_canvas` maps fractions of the axes to the canvas.
pub(crate) fn of_series(
    series: &Series,
    panel: &Panel,
    em: f64,
    on_canvas: &dyn Fn(Place) -> Place,
) -> Vec<Shape> {
    let unit = em / USUAL_LETTER;
    match series.look.mark {
        Mark::Line(_) => {
            let pieces = clip::visible_pieces(series, panel);
            let pieces = pieces.into_iter().map(|piece| piece.into_iter().map(on_canvas).collect()).collect();
            vec![line(ShapeRole::Curve, pieces, &series.look, unit)]
        }
        Mark::Markers(number) => {
            let shown: Vec<&Point> =
                series.points.iter().filter(|point| clip::is_visible(point, panel)).collect();
            let places = shown.iter().map(|point| on_canvas(clip::position(point, panel))).collect();
            let markers = markers(ShapeRole::Markers, number, places, &series.look, unit);
            bars(&shown, panel, &series.look, em, on_canvas).into_iter().chain([markers]).collect()
        }
        Mark::Band => vec![band(series, panel, on_canvas)],
    }
}

/// The sample of a series in a legend; it begins at this point and extends to the right.
pub(crate) fn sample(series: &Series, (left, middle): Place, length: f64, em: f64) -> Vec<Shape> {
    let unit = em / USUAL_LETTER;
    match series.look.mark {
        Mark::Line(_) => {
            vec![line(
                ShapeRole::Sample,
                vec![vec![(left, middle), (left + length, middle)]],
                &series.look,
                unit,
            )]
        }
        Mark::Markers(number) => {
            let look = Look { width: series.look.width.max(LEAST_SAMPLE), ..series.look.clone() };
            vec![markers(ShapeRole::Sample, number, vec![(left + 0.5 * length, middle)], &look, unit)]
        }
        Mark::Band => {
            let (up, down, right) = (middle - 0.35 * em, middle + 0.35 * em, left + length);
            let outline = vec![(left, up), (right, up), (right, down), (left, down)];
            vec![shape(ShapeRole::Sample, Form::Areas(vec![outline]), &series.look)]
        }
    }
}

fn shape(role: ShapeRole, form: Form, look: &Look) -> Shape {
    Shape { role, form, colour: look.colour, opacity: look.opacity }
}

fn line(role: ShapeRole, pieces: Vec<Vec<Place>>, look: &Look, unit: f64) -> Shape {
    let dashes = if let Mark::Line(dashes) = look.mark { dashes } else { &[] };
    let dashes = dashes.iter().map(|length| length * unit).collect();
    shape(role, Form::Lines { pieces, width: look.width * unit, dashes }, look)
}

fn markers(role: ShapeRole, number: usize, places: Vec<Place>, look: &Look, unit: f64) -> Shape {
    let size = look.width * unit;
    let corners: &[Place] = match number % 4 {
        0 => return shape(role, Form::Dots { places, radius: size }, look),
        1 => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => &[(0.0, -1.1), (1.1, 1.1), (-1.1, 1.1)],
        _ => &[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)],
    };
    let outline =
        |(x, y): Place| corners.iter().map(|(dx, dy)| (size.mul_add(*dx, x), size.mul_add(*dy, y))).collect();
    shape(role, Form::Areas(places.into_iter().map(outline).collect()), look)
}

/// Error bars, clipped to the frame.
fn bars(
    shown: &[&Point],
    panel: &Panel,
    look: &Look,
    em: f64,
    on_canvas: &dyn Fn(Place) -> Place,
) -> Option<Shape> {
    let mut pieces = vec![];
    for point in shown {
        let here = clip::position(point, panel);
        let ends = |uncertainty: f64, value: f64, part: &dyn Fn(f64) -> f64| {
            [value - uncertainty, value + uncertainty].map(|end| part(end).clamp(0.0, 1.0))
        };
        if let Some(uncertainty) = point.x_uncertainty {
            let [from, to] = ends(uncertainty, point.x, &|x| panel.x.part(x)).map(|x| on_canvas((x, here.1)));
            let cap = |(x, y): Place| vec![(x, y - CAP * em), (x, y + CAP * em)];
            pieces.extend([vec![from, to], cap(from), cap(to)]);
        }
        if let Some(uncertainty) = point.y_uncertainty {
            let [from, to] = ends(uncertainty, point.y, &|y| panel.y.part(y)).map(|y| on_canvas((here.0, y)));
            let cap = |(x, y): Place| vec![(x - CAP * em, y), (x + CAP * em, y)];
            pieces.extend([vec![from, to], cap(from), cap(to)]);
        }
    }
    let thin = Look { width: 1.0, mark: Mark::Line(&[]), ..look.clone() };
    (!pieces.is_empty()).then(|| line(ShapeRole::Bars, pieces, &thin, em / USUAL_LETTER))
}

/// The outline of a band: along the lower ends of the uncertainties to the right, and back along the upper ones.
fn band(series: &Series, panel: &Panel, on_canvas: &dyn Fn(Place) -> Place) -> Shape {
    let edge = |point: &Point, side: f64| {
        let y = point.y + side * point.y_uncertainty.unwrap_or(0.0);
        let (x, y) = (panel.x.part(point.x), panel.y.part(y));
        on_canvas((x.clamp(0.0, 1.0), y.clamp(0.0, 1.0)))
    };
    let below = series.points.iter().map(|point| edge(point, -1.0));
    let above = series.points.iter().rev().map(|point| edge(point, 1.0));
    shape(ShapeRole::Band, Form::Areas(vec![below.chain(above).collect()]), &series.look)
}
