//! The laboratory of `libration`: reads what instruments recorded of a pendulum, and fits g, the period and the damping to it.
//!
//! | module | answers |
//! |---|---|
//! | [`measurement`] | an instrument's file as columns with quantities and units, and its traces |
//! | [`fit`] | fits of the exact law to measured periods, swings, lengths and passages of a gate: T0, a test of the law, gravity, damping |
//!
//! Both read bytes and return values: files, the screen and the clock belong to the caller.

pub mod fit;
pub mod measurement;
mod parallel;
mod statistics;
