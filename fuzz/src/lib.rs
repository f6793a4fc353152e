//! Hostile input for the parsers: mutations of a corpus, by a seeded generator.
//!
//! A target fails if it panics, if one of its properties does not hold, or if an input takes longer than ten seconds. The tests run a fixed
//! number of inputs; with `LIBRATION_FUZZ_SECONDS` each target runs for that time from a new seed, which is printed. `LIBRATION_SEED` repeats a
//! run.
//!
//! # Method
//! Coverage is not measured, so that stable Rust suffices. Inputs are spliced from a corpus with every notation of the documentation and changed
//! by tokens of a dictionary, which reaches deep states without coverage.

pub mod corpus;
pub mod mutation;
pub mod runner;
pub mod targets;
