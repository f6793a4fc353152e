//! Measured quantity, and the columns that hold it.

use super::super::Observable;

/// Measured quantity, with its columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value {
    Column(usize, Observable),
    Positions {
        x: usize,
        y: usize,
    },
    /// Three axes of a gyroscope, and the direction about which it turns.
    Axes([usize; 3], [f64; 3]),
}

impl Value {
    /// The columns it needs.
    pub(super) fn places(self) -> Vec<usize> {
        match self {
            Self::Column(column, _) => vec![column],
            Self::Positions { x, y } => vec![x, y],
            Self::Axes(axes, _) => axes.to_vec(),
        }
    }
}
