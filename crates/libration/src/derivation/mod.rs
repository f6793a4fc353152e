//! What was derived, derived again.

pub mod paper;
