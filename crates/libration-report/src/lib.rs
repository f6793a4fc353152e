//! Pictures of results: described as data, laid out for a column, a page or a slide, and written as SVG.
//!
//! A [`Picture`](chart::Picture) states the content. [`draw`] lays it out in a [`PictureFormat`](format::PictureFormat) and returns a
//! [`Scene`](scene::Scene) of lines, dots and text, which [`svg`] writes; other renderers draw the same scene. The crate reads no files and no
//! clock.
//!
//! # Method
//! The layout (`frame`) first breaks text into lines, so that all heights follow from the width; the axes share the rest. The layout computes
//! the smallest size that holds a picture. Ticks (`ticks`) are the closest set whose labels do not touch. A scene has units of 1/96 inch, and
//! each shape has the class of the thing that it represents. Widths of letters are those of the font in the command (a subset of `DejaVu Sans`);
//! a test compares the two.

pub mod chart;
pub mod format;
pub mod range;
pub mod scene;
pub mod style;
pub mod svg;
mod advances;
mod angles;
mod animation;
mod clip;
mod curve_names;
mod describe;
mod draw;
mod frame;
mod legend;
mod letters;
mod marks;
mod numbers;
mod ticks;

pub use draw::draw;
pub use letters::{Run, runs, width as text_width};

/// Internals that the test suite uses; they may change at any time.
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
