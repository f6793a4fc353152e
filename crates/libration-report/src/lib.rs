//! Answers as they are shown: pictures described as data, laid out for a column, a page or a slide, and written as SVG.
//!
//! A [`Picture`](chart::Picture) says what is shown. [`draw`] lays it out in a [`PictureFormat`](format::PictureFormat) and gives a
//! [`Scene`](scene::Scene) of lines, dots and text, which [`svg`] writes; other renderers draw the same scene. Nothing here
//! reads files or asks for the time.
//!
//! # Method
//! The layout (`frame`) breaks text into lines first, so that all heights follow from the width; the axes share the rest. It knows the smallest
//! size that holds a picture. Ticks (`ticks`) are chosen from close to wide: the closest set that keeps its labels apart. A scene has units of 1/96
//! inch, and each shape carries the class of the thing that it stands for. Widths of letters are those of the font within the command (a part of
//! `DejaVu Sans`); a test holds both together.

pub mod chart;
pub mod format;
pub mod range;
pub mod scene;
pub mod style;
pub mod svg;

mod advances;
mod animation;
mod clip;
mod describe;
mod draw;
mod frame;
mod legend;
mod letters;
mod marks;
mod numbers;
mod ticks;

pub use draw::draw;
pub use letters::width as text_width;

/// Internals that the suite tests; no promise of stability.
#[doc(hidden)]
pub mod internals {
    pub mod clip {
        pub use crate::clip::visible_pieces;
    }
    pub mod letters {
        pub use crate::letters::{width, wrapped};
    }
    pub mod numbers {
        pub use crate::numbers::{of_steps, power_of_ten, short};
    }
    pub mod svg {
        pub use crate::svg::{dots, escaped, rounded};
    }
    pub mod ticks {
        pub use crate::ticks::{choices, chosen};
    }
}
