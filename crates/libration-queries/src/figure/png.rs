//! A scene as PNG, drawn by tiny-skia.

use super::font::{Font, single};
use libration_report::scene::{Anchor, Form, Place, Scene, Shape, Text};
use libration_report::style::{PAPER, rgb};
use tiny_skia::{
    FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

/// 300 dots in an inch.
const PIXELS_PER_UNIT: f64 = 300.0 / 96.0;
/// A larger side would take gigabytes.
const MOST_PIXELS: f64 = 9600.0;

/// The bytes of a PNG file, or the reason why there are none.
pub(crate) fn file(scene: &Scene) -> Result<Vec<u8>, String> {
    let canvas = Canvas::new(scene).ok_or("there is not enough memory for a picture of this size")?;
    canvas.drawn(scene).encode_png().map_err(|error| error.to_string())
}

struct Canvas {
    pixmap: Pixmap,
    scale: Transform,
    font: Font,
}

impl Canvas {
    fn new(scene: &Scene) -> Option<Self> {
        let scale = PIXELS_PER_UNIT.min(MOST_PIXELS / scene.width.max(scene.height));
        let [width, height] = [scene.width, scene.height].map(|side| whole(side * scale));
        let scale = Transform::from_scale(single(scale), single(scale));
        Some(Self { pixmap: Pixmap::new(width, height)?, scale, font: Font::new()? })
    }

    fn drawn(mut self, scene: &Scene) -> Pixmap {
        self.pixmap.fill(colour(PAPER, 1.0));
        scene.shapes().for_each(|shape| self.draw(shape));
        self.pixmap
    }

    fn draw(&mut self, shape: &Shape) {
        let mut paint = Paint::default();
        paint.set_color(colour(shape.colour, shape.opacity));
        match &shape.form {
            Form::Lines { pieces, width, dashes } => {
                let stroke = stroke(*width, dashes);
                for path in pieces.iter().filter_map(|piece| path(piece, Ends::Open)) {
                    self.pixmap.stroke_path(&path, &paint, &stroke, self.scale, None);
                }
            }
            Form::Areas(areas) => {
                areas
                    .iter()
                    .filter_map(|area| path(area, Ends::Joined))
                    .for_each(|path| self.fill(&path, &paint));
            }
            Form::Dots { places, radius } => {
                for (x, y) in places {
                    let dot = PathBuilder::from_circle(single(*x), single(*y), single(*radius));
                    if let Some(dot) = dot {
                        self.fill(&dot, &paint);
                    }
                }
            }
            Form::Text(text) => self.write(text, &paint),
        }
    }

    fn fill(&mut self, path: &Path, paint: &Paint<'_>) {
        self.pixmap.fill_path(path, paint, FillRule::Winding, self.scale, None);
    }

    fn write(&mut self, text: &Text, paint: &Paint<'_>) {
        let (outline, width) = self.font.outline(&text.content);
        let before = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        let (size, (x, y)) = (single(text.size), text.at);
        let turn = if text.is_turned { -90.0 } else { 0.0 };
        let transform = Transform::from_translate(-before, 0.0)
            .post_scale(size, size)
            .post_rotate(turn)
            .post_translate(single(x), single(y));
        if let Some(outline) = outline.and_then(|outline| outline.transform(transform)) {
            self.fill(&outline, paint);
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Ends {
    Open,
    Joined,
}

fn path(places: &[Place], ends: Ends) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (first, rest) = places.split_first()?;
    path.move_to(single(first.0), single(first.1));
    rest.iter().for_each(|(x, y)| path.line_to(single(*x), single(*y)));
    if ends == Ends::Joined {
        path.close();
    }
    path.finish()
}

fn stroke(width: f64, dashes: &[f64]) -> Stroke {
    let dashes = dashes.iter().map(|length| single(*length)).collect();
    Stroke {
        width: single(width),
        line_cap: LineCap::Butt,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(dashes, 0.0),
        ..Stroke::default()
    }
}

fn colour(text: &str, opacity: f64) -> tiny_skia::Color {
    let [red, green, blue] = rgb(text);
    let mut colour = tiny_skia::Color::from_rgba8(red, green, blue, 255);
    colour.apply_opacity(single(opacity));
    colour
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "sides are above 0 and below 10000"
)]
fn whole(value: f64) -> u32 {
    // What rounding leaves does not count as a pixel.
    (value - 1e-6).ceil().max(1.0) as u32
}
