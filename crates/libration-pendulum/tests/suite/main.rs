//! Evidence for the pendulum: golden tables, published numbers and identities.
#![expect(clippy::unwrap_used, reason = "a test that cannot read its table should stop there")]
#![expect(clippy::float_cmp, reason = "exact values and equal bits are what some tests claim")]

// Tests are written as users of the crate `libration` would write them.
extern crate libration_pendulum as libration;

mod accuracy;
mod elliptic;
mod fourier;
mod ledger;
mod motion;
mod period;
mod period_formulas;
mod promises;
mod series;
mod unit;
