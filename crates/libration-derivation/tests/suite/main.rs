//! The derivations and their parts.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on should stop where it stands")]

mod answers;
mod averaging;
mod cosines;
mod decimal;
mod derivations;
mod latex;
mod limit_cycle;
mod lindstedt;
mod notebooks;
mod paper;
mod phase;
mod source;
mod symbolic_slow_flow;
mod symbols;
mod two_sided;
