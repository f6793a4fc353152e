//! The published approximations to the period.

mod expansion;

pub use expansion::{frequency_in_amplitude, period_in_amplitude, period_in_sine_squared};
