//! Queries in the process that asks them, and their parts by themselves.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on should stop where it stands")]

mod internals;
mod query_error;
mod sentences;
mod source;
