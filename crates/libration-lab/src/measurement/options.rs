//! How a file is read.

use super::dialect::Delimiter;
use super::number::DecimalMark;

/// Whether the first row names the columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Header {
    /// It does when not one of its cells is a number; lines of other kinds above it are left out.
    #[default]
    Detect,
    /// It does.
    Present,
    /// It does not.
    Absent,
    /// This line does, counted from one; what is above it is left out.
    Line(u64),
}

/// How a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReadOptions {
    /// What stands between cells; inferred from the file when not given.
    pub delimiter: Option<Delimiter>,
    /// Decimal point or decimal comma; inferred from the file when not given.
    pub decimal: Option<DecimalMark>,
    /// Whether the first row names the columns.
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
