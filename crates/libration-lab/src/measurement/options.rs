//! Options of reading a file.

use super::dialect::Delimiter;
use super::number::DecimalMark;

/// Presence of a row that names the columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Header {
    /// The first row names the columns when not one of its cells is a number; lines of other kinds above it are left out.
    #[default]
    Detect,
    /// The first row names the columns.
    Present,
    /// No row names the columns.
    Absent,
    /// The line of the names of the columns, counted from one; lines above it are left out.
    Line(u64),
}

/// Options of reading a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadOptions {
    /// Delimiter of cells; inferred from the file when not given.
    pub delimiter: Option<Delimiter>,
    /// Decimal point or decimal comma; inferred from the file when not given.
    pub decimal: Option<DecimalMark>,
    /// Presence of a row that names the columns.
    pub header: Header,
    /// The most bytes that are read.
    pub size_limit: usize,
}

impl ReadOptions {
    /// 64 MiB: a million rows of a period table.
    pub const DEFAULT_SIZE_LIMIT: usize = 64 << 20;
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { delimiter: None, decimal: None, header: Header::Detect, size_limit: Self::DEFAULT_SIZE_LIMIT }
    }
}
