//! The expansion as JSON and CSV.

use super::{Answer, fields};
use crate::output::json;
use std::io::{self, Write};

pub(super) fn write_json(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    json::document(out, fields::of_expansion().record(answer))
}

/// One coefficient a line.
pub(super) fn write_csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    fields::of_coefficient().write_csv(out, &fields::coefficients(&answer.expansion))
}
