//! Tools that the test suites of this workspace share: golden tables and how they are read, errors in units of the last place, seeded random inputs, how much of a sweep is run, and archives in which each field can be wrong.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]

pub mod condition;
pub mod golden;
pub mod random;
pub mod sources;
pub mod sweep;
pub mod ulp;
pub mod zip_archive;
