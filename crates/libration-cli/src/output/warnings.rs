//! What is doubtful about an answer.

use super::json::Record;

/// The warnings as people read them, and what each is about in a name that stays.
pub(crate) fn fields(record: Record, warnings: Vec<(&'static str, String)>) -> Record {
    let (kinds, texts): (Vec<&str>, Vec<String>) = warnings.into_iter().unzip();
    record.with("warnings", texts).with("warning_kinds", kinds)
}
