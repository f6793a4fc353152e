//! Excel workbooks since 2007, part by part.

mod contents;
mod worksheet;
