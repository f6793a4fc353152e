//! Periodic motions of any oscillator as exact series.

mod conservative;
mod gauge;
mod limit_cycle;
mod lindstedt;
mod model;
mod modular;
mod series_set;

#[cfg(test)]
mod tests;
