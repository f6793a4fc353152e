//! A scene as PDF, with its text as text.
//!
//! # Method
//! The canvas is turned upside down and scaled from units of 1/96 inch to points. Letters are glyphs of a part of the font that has only these
//! (`subsetter`), with a table of their characters, so that text can be searched and copied. The file has no date: equal pictures are equal
//! files.

use super::font::{FONT, Font, single};
use libration_report::scene::{Anchor, Form, Place, Scene, Shape, Text};
use libration_report::style::rgb;
use libration_report::{runs, text_width};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{CidFontType, FontFlags, LineCapStyle, LineJoinStyle, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};
use std::collections::{BTreeMap, BTreeSet};
use subsetter::{GlyphRemapper, subset};

/// Points in a unit of the scene.
const POINTS: f32 = 72.0 / 96.0;
/// The usual level of zlib, beyond which files hardly become smaller.
const COMPRESSION: u8 = 6;
const FONT_NAME: Name<'static> = Name(b"F");
const ORDERING: SystemInfo<'static> =
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// The numbers of the objects of a file.
const CATALOG: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const COMPOSITE_FONT: Ref = Ref::new(5);
const CID_FONT: Ref = Ref::new(6);
const DESCRIPTOR: Ref = Ref::new(7);
const FONT_FILE: Ref = Ref::new(8);
const CHARACTERS: Ref = Ref::new(9);
const INFORMATION: Ref = Ref::new(10);

/// The bytes of a PDF file; why there are none, if there are.
pub(crate) fn file(scene: &Scene) -> Result<Vec<u8>, String> {
    let font = Font::new().ok_or("the font within the command is damaged")?;
    let mut page = PdfPage::new(&font, single(scene.height) * POINTS);
    scene.shapes().for_each(|shape| page.draw(shape));
    page.file(scene)
}

struct PdfPage<'a> {
    content: Content,
    font: &'a Font,
    glyphs: GlyphRemapper,
    /// The letters in the file and their advance widths in thousandths, by their glyphs there.
    letters: BTreeMap<u16, (char, f32)>,
    /// The opacities below 1, in thousandths.
    opacities: BTreeSet<u16>,
}

impl<'a> PdfPage<'a> {
    fn new(font: &'a Font, height: f32) -> Self {
        let mut content = Content::new();
        content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, height]);
        content.set_line_join(LineJoinStyle::RoundJoin);
        let (glyphs, letters) = (GlyphRemapper::new(), BTreeMap::new());
        Self { content, font, glyphs, letters, opacities: BTreeSet::new() }
    }

    fn draw(&mut self, shape: &Shape) {
        let [red, green, blue] = rgb(shape.colour).map(|part| f32::from(part) / 255.0);
        self.content.save_state();
        self.set_opacity(shape.opacity);
        self.content.set_stroke_rgb(red, green, blue).set_fill_rgb(red, green, blue);
        match &shape.form {
            Form::Lines { pieces, width, dashes } => {
                self.content.set_line_width(hundredths(*width));
                self.content.set_dash_pattern(dashes.iter().map(|length| hundredths(*length)), 0.0);
                pieces.iter().for_each(|piece| self.outline(piece));
                self.content.stroke();
            }
            Form::Areas(areas) => {
                for area in areas {
                    self.outline(area);
                    self.content.close_path();
                }
                self.content.fill_nonzero();
            }
            // A line of zero length with round ends is a dot (ISO 32000-1, 8.5.3.2).
            Form::Dots { places, radius } => {
                self.content.set_line_width(hundredths(2.0 * radius));
                self.content.set_line_cap(LineCapStyle::RoundCap);
                places.iter().for_each(|centre| self.outline(&[*centre, *centre]));
                self.content.stroke();
            }
            Form::Text(text) => self.write(text),
        }
        self.content.restore_state();
    }

    fn set_opacity(&mut self, opacity: f64) {
        if opacity < 1.0 {
            let opacity = thousandths(opacity);
            self.opacities.insert(opacity);
            self.content.set_parameters(Name(opacity_name(opacity).as_bytes()));
        }
    }

    fn outline(&mut self, places: &[Place]) {
        for (number, (x, y)) in places.iter().enumerate() {
            let (x, y) = (hundredths(*x), hundredths(*y));
            if number == 0 {
                self.content.move_to(x, y)
            } else {
                self.content.line_to(x, y)
            };
        }
    }

    fn write(&mut self, text: &Text) {
        let before = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        } * text_width(&text.content, text.size);
        let (x, y) = text.at;
        // The letters of the page are upside down on the canvas.
        let matrix = if text.is_turned {
            [0.0, -1.0, -1.0, 0.0, hundredths(x), hundredths(y + before)]
        } else {
            [1.0, 0.0, 0.0, -1.0, hundredths(x - before), hundredths(y)]
        };
        self.content.begin_text().set_text_matrix(matrix);
        for run in runs(&text.content) {
            self.content.set_font(FONT_NAME, hundredths(run.scale * text.size));
            self.content.set_rise(hundredths(run.rise * text.size));
            let glyphs: Vec<u8> =
                run.letters.chars().flat_map(|letter| self.glyph(letter).to_be_bytes()).collect();
            self.content.show(Str(&glyphs));
        }
        self.content.end_text();
    }

    /// The glyph of a letter in the part of the font.
    fn glyph(&mut self, letter: char) -> u16 {
        let (glyph, advance) = self.font.glyph(letter);
        let glyph = self.glyphs.remap(glyph.0);
        self.letters.entry(glyph).or_insert((letter, 1000.0 * advance));
        glyph
    }

    fn file(self, scene: &Scene) -> Result<Vec<u8>, String> {
        let mut pdf = Pdf::new();
        pdf.catalog(CATALOG).pages(PAGES).lang(TextStr("en"));
        pdf.pages(PAGES).kids([PAGE]).count(1);
        let mut information = pdf.document_info(INFORMATION);
        information.title(TextStr(&scene.title)).subject(TextStr(&scene.description));
        information.finish();
        self.write_page(&mut pdf, scene);
        self.write_font(&mut pdf).map_err(|error| error.to_string())?;
        write_stream(&mut pdf, CONTENT, &self.content.finish());
        Ok(pdf.finish())
    }

    fn write_page(&self, pdf: &mut Pdf, scene: &Scene) {
        let mut page = pdf.page(PAGE);
        let [width, height] = [scene.width, scene.height].map(|side| single(side) * POINTS);
        page.parent(PAGES).media_box(Rect::new(0.0, 0.0, width, height)).contents(CONTENT);
        let mut resources = page.resources();
        resources.fonts().pair(FONT_NAME, COMPOSITE_FONT);
        let mut states = resources.ext_g_states();
        for opacity in &self.opacities {
            let part = f32::from(*opacity) / 1000.0;
            let name = opacity_name(*opacity);
            let mut state =
                states.insert(Name(name.as_bytes())).start::<pdf_writer::writers::ExtGraphicsState<'_>>();
            state.stroking_alpha(part).non_stroking_alpha(part);
        }
    }

    fn write_font(&self, pdf: &mut Pdf) -> Result<(), subsetter::Error> {
        let name = format!("{}+DejaVuSans", self.tag());
        let name = Name(name.as_bytes());
        pdf.type0_font(COMPOSITE_FONT)
            .base_font(name)
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(CID_FONT)
            .to_unicode(CHARACTERS);
        let mut font = pdf.cid_font(CID_FONT);
        font.subtype(CidFontType::Type2).base_font(name).system_info(ORDERING).font_descriptor(DESCRIPTOR);
        font.default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
        let mut widths = font.widths();
        for (glyph, (_, advance)) in &self.letters {
            widths.same(*glyph, *glyph, *advance);
        }
        widths.finish();
        font.finish();
        self.write_descriptor(pdf, name);
        let mut characters = UnicodeCmap::new(Name(b"Custom"), ORDERING);
        for (glyph, (letter, _)) in &self.letters {
            characters.pair(*glyph, *letter);
        }
        write_stream(pdf, CHARACTERS, &characters.finish());
        write_stream(pdf, FONT_FILE, &subset(FONT, 0, &self.glyphs)?);
        Ok(())
    }

    fn write_descriptor(&self, pdf: &mut Pdf, name: Name<'_>) {
        let face = &self.font.0;
        let thousandths = |length: i16| 1000.0 * f32::from(length) / f32::from(face.units_per_em());
        let extent = face.global_bounding_box();
        let [left, bottom, right, top] =
            [extent.x_min, extent.y_min, extent.x_max, extent.y_max].map(thousandths);
        pdf.font_descriptor(DESCRIPTOR)
            .name(name)
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(left, bottom, right, top))
            .italic_angle(0.0)
            .ascent(thousandths(face.ascender()))
            .descent(thousandths(face.descender()))
            .cap_height(thousandths(face.capital_height().unwrap_or_default()))
            // The width of the stem of an l of this font.
            .stem_v(90.0)
            .font_file2(FONT_FILE);
    }

    /// Six capital letters that differ where the letters of the file differ, so that files can be joined in one document (FNV-1a).
    fn tag(&self) -> String {
        let mix = |hash: u64, letter: char| (hash ^ u64::from(letter)).wrapping_mul(0x0100_0000_01b3);
        let mut hash =
            self.letters.values().fold(0xcbf2_9ce4_8422_2325, |hash, (letter, _)| mix(hash, *letter));
        let mut letter = || {
            let number = u8::try_from(hash % 26).unwrap_or_default();
            hash /= 26;
            char::from(b'A' + number)
        };
        (0..6).map(|_| letter()).collect()
    }
}

fn write_stream(pdf: &mut Pdf, number: Ref, bytes: &[u8]) {
    let compressed = compress_to_vec_zlib(bytes, COMPRESSION);
    let length = i32::try_from(bytes.len()).unwrap_or(i32::MAX);
    let mut stream = pdf.stream(number, &compressed);
    stream.filter(Filter::FlateDecode);
    if number == FONT_FILE {
        stream.pair(Name(b"Length1"), length);
    }
}

fn opacity_name(thousandths: u16) -> String {
    format!("A{thousandths}")
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "an opacity lies between 0 and 1"
)]
fn thousandths(opacity: f64) -> u16 {
    (1000.0 * opacity).round() as u16
}

/// A length rounded to hundredths of a unit, which is written with few digits.
fn hundredths(length: f64) -> f32 {
    single((100.0 * length).round() / 100.0)
}
