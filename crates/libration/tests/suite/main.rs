//! The evidence for all parts together.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]

mod progress;
