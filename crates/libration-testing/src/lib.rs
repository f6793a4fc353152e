//! Tools that the test suites of this workspace share: golden tables and their reader, errors in units in the last place, seeded random inputs,
//! the extent of sweeps, and ZIP archives in which each field can be wrong.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]

pub mod condition;
pub mod golden;
pub mod random;
pub mod sources;
pub mod sweep;
pub mod ulp;
pub mod zip_archive;
