//! The expansion as JSON and CSV.

use super::answer::ExpandResult;
use super::fields;
use crate::output::json;
use crate::output::series::Coefficient;
use std::io::{self, Write};

pub(super) fn write_json<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    json::document(out, fields::of_expansion().record(answer))
}

/// One coefficient a line.
pub(super) fn write_csv<C: Coefficient>(out: &mut dyn Write, answer: &ExpandResult<C>) -> io::Result<()> {
    fields::of_coefficient().write_csv(out, &fields::coefficients(answer))
}
