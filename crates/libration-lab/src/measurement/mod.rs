//! Files of instruments → columns with quantities and units → traces of a swing, or times of a photogate.
//!
//! A [`Recording`] is read from bytes: text with commas, semicolons, tabs or blanks between its cells, decimal points or commas, in
//! UTF-8, UTF-16 or Windows-1252; Excel workbooks, old and new; archives of text files. Lines that begin with `#` or `%` are remarks.
//! Its [`Sheet`]s have [`Channel`]s, whose headings say quantity, unit and run.
//!
//! [`Recording::traces`] and [`Recording::gate_times`] tell from these what was measured. Each guess is a [`Finding`], and [`Choices`]
//! override it. What a file does not decide is refused with the choices that would. Every complaint names its line.
//! [`Table`] is for columns that are requested by name or number; each has a [`Role`], which its heading may contradict.
//!
//! # Method
//! Bytes become pages of text (`container`): a text file is one page, each worksheet and each file of an archive another. A page becomes a sheet:
//! `markup` takes the cells out of Markdown, LaTeX and HTML, `dialect` finds the delimiter and the decimal mark, `layout` where the numbers begin and
//! the roles of the lines above them, `heading` the quantity and unit of a column, `compound` numbers of two units, and `parts` columns of them; `transposed` exchanges rows and columns of a table with quantities
//! in rows, and `blocks` divides tables below one another. A `Recording` decides nothing about physics; `traces` does, and reports each inference. What
//! the file leaves open
//! is an error that lists the information needed, never a default: an angle without a unit is refused, unless it swings by more than a turn of
//! radians. Commas are refused where they may be decimal or not. Sizes, counts and cell addresses that a file announces are checked before memory
//! is allocated for them.

mod ambiguity;
mod blocks;
mod cell_units;
mod choices;
mod compound;
pub(crate) mod container;
pub(crate) mod counted_periods;
mod dialect;
mod error;
pub(crate) mod faults;
mod fitted_pivot;
mod gates;
mod glued;
mod header;
pub(crate) mod heading;
mod layout;
mod line_ends;
mod markup;
pub(crate) mod number;
mod numbered_time;
mod options;
mod parts;
mod recording;
mod repeated_rows;
mod role;
mod roles;
mod sheet;
mod signal;
mod table;
mod text;
mod trace;
pub(crate) mod traces;
mod transposed;
mod two_levels;
mod words;
mod written_unit;

pub use choices::{Choice, Choices, Column, Finding, Suggestion, TimeStamps};
pub use container::Format;
pub use counted_periods::{
    CountedPeriods, is_number_of_swings, says_number_of_half_swings, says_number_of_swings,
};
pub use dialect::{Delimiter, Dialect};
pub use error::MeasurementError;
pub use faults::{Clock, Faults, Gap, Grid, Plateau, unwrapped};
pub use fitted_pivot::FittedPivot;
pub use gates::Gates;
pub use heading::{Heading, QuantityKind, StatedUncertainty, Unit, UnknownUnit};
pub use number::DecimalMark;
pub use options::{Header, ReadOptions};
pub use recording::Recording;
pub use repeated_rows::RepeatedRows;
pub use role::{Role, WrittenUnit};
pub use roles::{ColumnRole, GivenRoles, QuantityColumns, TableQuantity, TableRoles, UncertaintyKind};
pub use sheet::{Channel, Sheet};
pub use signal::{SignalPassage, SignalPassages};
pub use table::{Readings, Selection, Table};
pub use text::Encoding;
pub use trace::{Observable, Trace, TraceError};
pub use traces::{Traces, is_run};
