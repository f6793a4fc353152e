//! What can be wrong with a table of measurements.

/// Why a file is no table of numbers, or has not the columns asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasurementError {
    /// More bytes than the limit.
    #[error("the file has {size} bytes, the limit is {limit}: give a smaller table")]
    TooLarge {
        /// Bytes.
        size: usize,
        /// Bytes.
        limit: usize,
    },
    /// Not text in UTF-8.
    #[error("the file is {0}, not a table as UTF-8 text: export it as CSV in UTF-8")]
    NotText(&'static str),
    /// Nothing but blank lines, comments and perhaps a header.
    #[error("the file has no rows of data: give at least one line of numbers")]
    Empty,
    /// A row with another number of cells than the others.
    #[error("line {line} has {found} cells where {expected} were expected: complete or remove the row")]
    Ragged {
        /// Counted from one.
        line: u64,
        /// Cells in the row.
        found: usize,
        /// Cells in the rows before.
        expected: usize,
    },
    /// A cell that is no finite number.
    #[error("line {line}, column {column}: `{cell}` is not a finite number: write it as 1.25 or 1.25e-3")]
    NotANumber {
        /// Counted from one.
        line: u64,
        /// Counted from one.
        column: usize,
        /// The cell, shortened.
        cell: String,
    },
    /// No column of this number or name.
    #[error("there is no column `{asked}`: the table has {available}")]
    NoSuchColumn {
        /// The number or name.
        asked: String,
        /// What there is.
        available: String,
    },
    /// Two columns of this name.
    #[error("several columns are named `{0}`: ask by number, counted from 1")]
    AmbiguousColumn(String),
    /// Not one row is complete in the columns asked for.
    #[error("none of the {0} rows has a number in every column asked for: ask for other columns")]
    NothingComplete(usize),
}
