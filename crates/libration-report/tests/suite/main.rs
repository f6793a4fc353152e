//! The layout of pictures, piece by piece.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on should stop where it stands")]

mod clip;
mod letters;
mod numbers;
mod range;
mod source;
mod svg;
mod ticks;
