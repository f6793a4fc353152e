//! The expansion as JSON and CSV.

use super::{Answer, fields};
use crate::output::{csv, json};
use std::io::{self, Write};

pub(super) fn write_json(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    json::document(out, fields::of_expansion().record(answer))
}

/// One coefficient a line.
pub(super) fn write_csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    csv::table(out, &fields::of_coefficient(), &fields::coefficients(&answer.expansion))
}
