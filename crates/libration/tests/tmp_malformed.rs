//! tmp
#[path = "suite/malformed/mod.rs"]
mod malformed;
