//! The letters of PNG and PDF: a part of `DejaVu Sans` within the command, so that every system draws the same.

use libration_report::runs;
use tiny_skia::{Path, PathBuilder, Transform};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Latin, Greek and Cyrillic letters and the signs of formulas, by `pyftsubset` from `DejaVu Sans` 2.37.
pub(super) const FONT: &[u8] = include_bytes!("../../assets/DejaVuSans.ttf");

/// The font, ready to draw.
#[expect(missing_debug_implementations, reason = "a face is shown by what it draws")]
pub struct Font(pub(super) Face<'static>);

impl Font {
    /// Loads the font; `None` if it were damaged.
    pub fn new() -> Option<Self> {
        Face::parse(FONT, 0).ok().map(Self)
    }

    /// The outline of a text of size 1 that begins at the origin, upside down as on a canvas, and its width.
    pub fn outline(&self, text: &str) -> (Option<Path>, f32) {
        let (mut all, mut at) = (PathBuilder::new(), 0.0);
        for run in runs(text) {
            let (scale, rise) = (single(run.scale), single(run.rise));
            let size = scale * f32::from(self.0.units_per_em()).recip();
            for letter in run.letters.chars() {
                let (glyph, advance) = self.glyph(letter);
                let mut pen = Pen(PathBuilder::new());
                self.0.outline_glyph(glyph, &mut pen);
                let transform = Transform::from_row(size, 0.0, 0.0, -size, at, -rise);
                if let Some(path) = pen.0.finish().and_then(|path| path.transform(transform)) {
                    all.push_path(&path);
                }
                at += scale * advance;
            }
        }
        (all.finish(), at)
    }

    /// The glyph of a letter and its advance width, as a fraction of the font size.
    pub(super) fn glyph(&self, letter: char) -> (GlyphId, f32) {
        let glyph = self.0.glyph_index(letter).unwrap_or_default();
        let advance = f32::from(self.0.glyph_hor_advance(glyph).unwrap_or_default());
        (glyph, advance / f32::from(self.0.units_per_em()))
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a picture needs no more digits")]
pub(super) fn single(value: f64) -> f32 {
    value as f32
}

struct Pen(PathBuilder);

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.0.close();
    }
}
