//! Layout of a picture: the size of a page, a column or a slide, or sides of its own; title, names of curves and units of angles.

use super::chart::Picture;
use crate::query_error::{Parameter, QueryError, option};
use libration_report::draw;
use libration_report::format::{PictureFormat, TooSmall, UNITS_PER_MM};
use libration_report::scene::Scene;
use std::borrow::Cow;
use std::fmt;

/// The options for the layout of a picture.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Layout {
    /// Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with larger type
    #[arg(long, value_enum, default_value = "page", requires = "figure")]
    size: Preset,
    /// Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by --size]
    #[arg(long, value_name = "LENGTH", value_parser = side, requires = "figure")]
    width: Option<PictureSide>,
    /// Height of the picture [default: chosen to suit the picture]
    #[arg(long, value_name = "LENGTH", value_parser = side, requires = "figure")]
    height: Option<PictureSide>,
    /// Leave out the title and the parameters under it, for a figure with a caption
    #[arg(long, requires = "figure")]
    no_title: bool,
    /// Write the names of curves next to them where there is room, and the others in the legend
    #[arg(long, requires = "figure")]
    curve_labels: bool,
    /// Unit of the angles along the axes [default: the usual one of the picture]
    #[arg(long, value_enum, requires = "figure")]
    angles: Option<Angles>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Preset {
    Page,
    Column,
    Slide,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Angles {
    Degrees,
    Radians,
}

/// A length with the unit it was given in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSide {
    length: f64,
    unit: &'static Unit,
}

#[derive(Debug, PartialEq)]
struct Unit {
    name: &'static str,
    /// The side in units of a picture.
    size: f64,
}

const PIXEL: Unit = Unit { name: "", size: 1.0 };
const MILLIMETRE: Unit = Unit { name: "mm", size: UNITS_PER_MM };
/// Units by the endings of lengths; the last one that matches counts.
const UNITS: [Unit; 3] =
    [Unit { name: "px", size: 1.0 }, MILLIMETRE, Unit { name: "cm", size: 10.0 * UNITS_PER_MM }];

/// Largest side of a picture: larger ones take gigabytes as a PNG.
const LARGEST: f64 = 4000.0;

impl Layout {
    /// The picture laid out as requested, if there is enough room.
    pub(super) fn scene(&self, picture: &Picture) -> Result<Scene, QueryError> {
        let format = self.format();
        let refused = |side: Parameter, asked: Option<PictureSide>, usual: f64, least: f64| {
            let asked =
                asked.unwrap_or(PictureSide { length: (usual / UNITS_PER_MM).round(), unit: &MILLIMETRE });
            // The change of units may round a whole number up.
            let least = PictureSide { length: (least / asked.unit.size - 1e-6).ceil(), ..asked };
            let reason =
                format!("{asked} is too small for this picture and its labels: give at least {least}");
            QueryError::no_result(side, reason).with_suggestion(Some(least.to_string()))
        };
        draw(&self.content(picture), &format).map_err(|error| match error {
            TooSmall::Width(least) => refused(option("width"), self.width, format.width, least),
            TooSmall::Height(least) => {
                refused(option("height"), self.height, format.height.unwrap_or(0.0), least)
            }
        })
    }

    /// The picture with its angles in the unit requested, and without the title if it is left out.
    pub(super) fn content<'a>(&self, picture: &'a Picture) -> Cow<'a, Picture> {
        let mut content = self.with_angles(picture).map_or(Cow::Borrowed(picture), Cow::Owned);
        if self.no_title {
            let content = content.to_mut();
            content.title.clear();
            content.parameters.clear();
        }
        content
    }

    /// The picture with its angles in the unit requested; `None` if it has none.
    fn with_angles(&self, picture: &Picture) -> Option<Picture> {
        match self.angles? {
            Angles::Degrees => picture.in_degrees(),
            Angles::Radians => picture.in_radians(),
        }
    }

    /// The remark that an option has no effect on this picture.
    pub(super) fn remark(&self, picture: &Picture) -> &'static str {
        let is_idle = self.angles.is_some() && self.with_angles(picture).is_none();
        if is_idle { "; there are no angles along its axes" } else { "" }
    }

    /// The remark that options have no effect on the data of a picture.
    pub(super) fn remark_on_data(&self) -> &'static str {
        let is_usual = matches!(self.size, Preset::Page) && self.width.is_none() && self.height.is_none();
        if is_usual && !self.curve_labels { "" } else { "; data have no size and no names at curves" }
    }

    fn format(&self) -> PictureFormat {
        let usual = match self.size {
            Preset::Page => PictureFormat::PAGE,
            Preset::Column => PictureFormat::COLUMN,
            Preset::Slide => PictureFormat::SLIDE,
        };
        let usual = PictureFormat { has_title: !self.no_title, names_curves: self.curve_labels, ..usual };
        let height = self.height.map(PictureSide::in_units);
        match self.width {
            // A width of one's own leaves the height to the picture.
            Some(width) => PictureFormat { width: width.in_units(), height, ..usual },
            None => PictureFormat { height: height.or(usual.height), ..usual },
        }
    }
}

impl PictureSide {
    /// The length in the units of a picture.
    pub fn in_units(self) -> f64 {
        self.length * self.unit.size
    }
}

impl fmt::Display for PictureSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.length, self.unit.name)
    }
}

/// A side of a picture, up to a poster's.
pub fn side(text: &str) -> Result<PictureSide, String> {
    let text = text.trim();
    let unit = UNITS.iter().find(|unit| text.ends_with(unit.name)).unwrap_or(&PIXEL);
    let number = text[..text.len() - unit.name.len()].trim().parse().ok();
    let side = number.map(|length| PictureSide { length, unit });
    side.filter(|side| side.length > 0.0 && side.in_units() <= LARGEST).ok_or_else(|| {
        let most = (LARGEST / UNITS_PER_MM).floor();
        format!("give a length above 0, such as 80mm, 12cm or 600 (pixels), at most {LARGEST} or {most}mm")
    })
}
