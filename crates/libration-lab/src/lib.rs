//! The laboratory of `libration`: what an instrument wrote about a pendulum, and what it says about g, the period and the damping.
//!
//! | module | answers |
//! |---|---|
//! | [`measurement`] | an instrument's file as columns with quantities and units, and the traces in it |
//! | [`fit`] | measured periods, swings, lengths and passages explained by the exact law: T0, its test, gravity, damping |
//!
//! Both read bytes and return values: files, the screen and the clock belong to the caller.

pub mod fit;
pub mod measurement;
mod statistics;
