//! Answers as they are shown: pictures described as data, laid out for a column, a page or a slide, and written as SVG.
//!
//! A [`Picture`](chart::Picture) says what is shown. [`draw`] lays it out in a [`PictureFormat`](format::PictureFormat) and gives a
//! [`Scene`](scene::Scene) of lines, dots and text, which [`svg`] writes; other renderers draw the same scene. Nothing here
//! reads files or asks for the time.

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
