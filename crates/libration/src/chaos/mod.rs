//! Regular or chaotic: Poincaré sections, bifurcation diagrams, the largest Lyapunov exponent.
//!
//! A section shows what a motion is: a point for a periodic one, a curve for one with two periods, a cloud or a fractal for a chaotic
//! one. A bifurcation diagram shows how that changes with a parameter. The exponent tells how fast neighbouring motions
//! part, and comes with a verdict that says `Chaotic` only on evidence.

mod drive;
mod structure;

mod section;

mod bifurcation;

mod extent;

mod lyapunov;

pub use bifurcation::{
    Continuation, DiagramColumn, DiagramError, Family, bifurcation_diagram, bifurcation_diagram_watched,
};
pub use drive::drive_period;
pub use lyapunov::{
    Doubt, LyapunovError, LyapunovExponent, LyapunovVerdict, Regularity, Schedule, lyapunov_exponent,
    lyapunov_exponent_watched,
};
pub use section::{
    PoincareSection, Points, Section, SectionEnding, SectionError, folded, section, section_watched,
};
pub use structure::{Theorem, angles};
