//! Regular or chaotic: Poincaré sections, bifurcation diagrams, the largest Lyapunov exponent.

mod drive;
mod structure;

mod section;

mod bifurcation;

mod extent;

mod lyapunov;

pub use bifurcation::{Column, Continuation, DiagramError, Family, bifurcation_diagram};
pub use drive::drive_period;
pub use lyapunov::{
    Doubt, LyapunovError, LyapunovExponent, Progress, Regularity, Schedule, Verdict, lyapunov_exponent,
};
pub use section::{Ending, PoincareSection, Points, Section, SectionError, folded, section};
pub use structure::{Theorem, angles};
