//! Regular or chaotic: Poincaré sections, bifurcation diagrams, the largest Lyapunov exponent.

mod drive;
mod structure;

mod extent;

mod lyapunov;

pub use drive::drive_period;
pub use lyapunov::{
    Doubt, LyapunovError, LyapunovExponent, Progress, Regularity, Schedule, Verdict, lyapunov_exponent,
};
pub use structure::{Theorem, angles};
