//! Regular or chaotic motion: Poincaré sections, bifurcation diagrams, the largest Lyapunov exponent.
//!
//! A section shows the kind of a motion: a point for a periodic one, a curve for one with two periods, a cloud
//! or a fractal for a chaotic one. A bifurcation diagram shows its dependence on a parameter. The exponent is
//! the rate at which neighbouring motions diverge, and comes with a verdict that is `Chaotic` only on evidence.
//!
//! ```
//! # extern crate libration_motion as libration;
//! use libration::chaos::{Continuation, Family, Points, Section, compute_bifurcation_diagram};
//! use libration::progress::Quiet;
//! use libration::taylor::{Effort, Moment};
//!
//! // A driven pendulum, once in each period of its drive: a stronger drive doubles the period of the response.
//! let family = Family {
//!     equation: &"theta'' + theta'/2 + sin(theta) = A*cos(2t/3)".parse()?,
//!     parameter: "A",
//!     section: &Section::Stroboscope { period: None, phase: 0.0 },
//!     points: Points { skipped: 300, recorded: 3 },
//!     with_errors: false,
//! };
//! let start = Moment { time: 0.0, state: vec![0.2, 0.0] };
//! let effort = Effort::to_tolerance(1e-9);
//! let columns = compute_bifurcation_diagram(&family, &[0.9, 1.07], &start, Continuation::SameStart, &effort, &Quiet)?;
//! let velocities = |column: usize| columns[column].section.points.iter().map(|point| point.state[1]).collect::<Vec<_>>();
//! let (weak, strong) = (velocities(0), velocities(1));
//! assert!((weak[0] - weak[1]).abs() < 1e-6);
//! assert!((strong[0] - strong[1]).abs() > 0.1 && (strong[0] - strong[2]).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod drive;
mod repetitions;
pub(crate) mod structure;
mod surface;
mod section;
mod bifurcation;
mod extent;
pub(crate) mod lyapunov;

pub use bifurcation::{Continuation, DiagramColumn, DiagramError, Family, compute_bifurcation_diagram};
pub use drive::{drive_frequency, drive_period};
pub use lyapunov::{
    Doubt, LyapunovError, LyapunovExponent, LyapunovVerdict, Regularity, Schedule, lyapunov_exponent,
};
pub use section::{
    PoincareSection, Points, Section, SectionEnding, SectionError, SectionErrors, compute_section,
    compute_section_with_errors, folded,
};
pub use structure::{Theorem, angles, turning_groups};
