//! Evidence for the kernels: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]

// Tests are written as users of the crate `libration` would write them.
extern crate libration_kernels as libration;

mod elliptic_batches;
mod unit;
