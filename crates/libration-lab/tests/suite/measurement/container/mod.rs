//! Files that hold several tables, part by part.

mod date_formats;
mod grid;
mod xls;
mod xlsx;
