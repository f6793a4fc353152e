//! Size of a picture and of its letters, for a column, a page or a slide, and what is written next to its curves.

use thiserror::Error;

/// Units of length in a millimetre; 96 units are an inch, as in browsers.
pub const UNITS_PER_MM: f64 = 96.0 / 25.4;

/// Twelve points.
const TWELVE_POINTS: f64 = 16.0;
/// Approximate width of the text on a page.
const PAGE: f64 = 170.0 * UNITS_PER_MM;

/// The size of a picture, in units of 1/96 inch, the size of its letters, and its texts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureFormat {
    /// Width of the picture.
    pub width: f64,
    /// Height of the picture; if it is `None`, the shape of the picture decides.
    pub height: Option<f64>,
    /// The size of the letters.
    pub text: f64,
    /// `true` if the title and the parameters are above the picture; a figure with a caption needs neither.
    pub has_title: bool,
    /// `true` if a curve has its name next to it, where there is room, and not in the legend.
    pub names_curves: bool,
}

impl PictureFormat {
    /// A picture as wide as the text of a page, with letters of 12 points.
    pub const PAGE: Self =
        Self { width: PAGE, height: None, text: TWELVE_POINTS, has_title: true, names_curves: false };
    /// A picture as wide as a column of a journal, 80 mm, with letters of 12 points.
    pub const COLUMN: Self = Self { width: 80.0 * UNITS_PER_MM, ..Self::PAGE };
    /// A slide, 16 to 9, with letters of 20 points.
    pub const SLIDE: Self = Self { width: 1280.0, height: Some(720.0), text: 80.0 / 3.0, ..Self::PAGE };
}

impl Default for PictureFormat {
    fn default() -> Self {
        Self::PAGE
    }
}

/// The reason why a format cannot hold the picture with its labels.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum TooSmall {
    /// Too narrow.
    #[error("it must be at least {0} wide")]
    Width(f64),
    /// Too low for its width.
    #[error("it must be at least {0} high")]
    Height(f64),
}
