//! The way from a recording to traces, part by part.

mod circle;
mod gyroscope;
mod sequence;
mod turns;
