//! Fits of traces, part by part.

mod autocorrelation;
mod clock;
mod comparison;
mod huber;
mod information;
mod noise;
mod profile;
mod search;
mod series;
mod swing;
mod systematic;
