//! Cycles of a measured swing, part by part.

mod centre;
mod decay_rates;
mod even;
mod generalised;
mod local_fit;
mod shape;
mod swings;
