//! Evidence for numbers, series and expressions: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]

// Tests are written as users of the crate `libration` would write them.
extern crate libration_numbers as libration;

mod equation;
mod expression;
mod quantity;
mod unit;
