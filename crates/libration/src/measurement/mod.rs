//! The bytes of a delimited text file → columns of numbers.
//!
//! Comma, semicolon, tab or white space between the cells; a decimal comma wherever the comma does not stand
//! between cells; a header or none; blank lines and lines that begin with `#` are skipped. Every complaint
//! names its line.

mod ambiguity;
mod choices;
mod container;
mod dialect;
mod error;
mod faults;
mod gates;
mod heading;
mod layout;
mod number;
mod recording;
mod sheet;
mod table;
mod text;
mod trace;
mod traces;

pub use choices::{Choice, Choices, Column, Finding, Suggestion};
pub use container::Format;
pub use dialect::{Delimiter, Dialect};
pub use error::MeasurementError;
pub use faults::{Clock, Faults, Gap, Grid, Run, unwrapped};

pub use gates::Gates;
pub use heading::{Heading, Quantity, Unit, UnknownUnit};
pub use number::DecimalMark;
pub use recording::Recording;
pub use sheet::{Channel, Sheet};
pub use table::{Header, Options, Selection, Table};
pub use text::Encoding;
pub use trace::{Seen, Trace, TraceError};
pub use traces::Traces;
