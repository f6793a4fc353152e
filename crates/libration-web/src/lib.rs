//! The exact pendulum for a page: functions by name, with texts and numbers in the memory of the module.
//!
//! The page writes a text into the [`exchange`], calls a function, and reads what it has left there: numbers, or the reason in words
//! why there are none. [`fused`] is the fused multiply-add of this module and of all that are made with it.

pub mod exchange;
pub mod fused;
pub mod motion;
pub mod quantities;
