//! Hostile input for the parsers: mutations of a corpus, by a seeded generator.
//!
//! A target fails where it panics, where one of its properties does not hold, and where an input takes longer than ten seconds. The tests run a fixed
//! number of inputs; with `LIBRATION_FUZZ_SECONDS` each target runs as long, from a new seed, which it prints. `LIBRATION_SEED` repeats one.
//!
//! # Method
//! No coverage is measured, so that stable Rust suffices: inputs are spliced from a corpus that holds each notation of the documentation, and
//! changed by tokens of a dictionary, which reaches deep states without it.

pub mod corpus;
pub mod mutation;
pub mod runner;
pub mod targets;
