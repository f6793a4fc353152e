//! The bytes of a delimited text file → columns of numbers.
//!
//! Comma, semicolon, tab or white space between the cells; a decimal comma wherever the comma does not stand
//! between cells; a header or none; blank lines and lines that begin with `#` are skipped. Every complaint
//! names its line.

mod dialect;
mod error;
mod faults;
mod number;
mod table;
mod text;
mod trace;

pub use dialect::Delimiter;
pub use error::MeasurementError;
pub use faults::{Clock, Faults, Gap, Grid, Run, unwrapped};
pub use table::{Column, Header, Options, Selection, Table};
pub use trace::{Seen, Trace, TraceError};
