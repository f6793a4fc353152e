//! Excel workbooks before 2007, part by part.

mod records;
mod strings;
