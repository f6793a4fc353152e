//! Branches of periodic motions of driven and self-excited systems over a parameter, through folds, with stability and errors.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::continuation::{Response, ResponseOptions, SpecialKind};
//! use libration::progress::Quiet;
//!
//! let pendulum = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
//! let response = Response::over(&pendulum, "w", [0.3, 1.4], &ResponseOptions::default(), &Quiet)?;
//! let folds: Vec<f64> = response.branches[0]
//!     .special
//!     .iter()
//!     .filter(|special| special.kind == SpecialKind::Fold)
//!     .map(|special| special.point.parameter)
//!     .collect();
//! // The upward jump in a downward sweep: by Fourier collocation 0.8721575691379171688795389.
//! assert!((folds[0] - 0.87215756913791717).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! A periodic motion is a fixed point of the map over the period of the drive. The integrator gives the map with its derivatives with respect to
//! the start and the parameter, including the derivative of the period, so that the drive frequency is a parameter like others. A branch is
//! followed from point to point along its tangent, with Newton's method perpendicular to it. The step is shortened if the prediction was far off
//! or the direction turns, which keeps neighbouring branches apart. `established.rs` tests whether a step may have skipped a special point;
//! parameter ranges in which even the minimum steps do not exclude that are listed. Where a force jumps, a branch is
//! continued beyond the motion at which the number of stops changes, next to which deviations have no derivatives.
//!
//! At each end of the range, or at one given value, branches begin with the motion that Newton's method finds from the start, and with further
//! motions near estimates by harmonic balance (`further_starts.rs`), within the range too if there are several wells; and with those to which the system settles beyond a fold where no known motion
//! is stable (`landings.rs`). Not searched are motions with many harmonics, other periods, isolas within the range, and without a drive other
//! cycles than that to which the start settles.
//!
//! Motions that are their own mirror images half a period later are followed by the half map with a mirror (`space.rs`). Its multiplier +1 is a
//! fold and −1 a symmetry-breaking bifurcation; the whole map could not distinguish them. The existence of mirror images, about zero or another
//! centre, is a property of the equation (`symmetry.rs`, `centre.rs`); the image about the bottom of a motion about the top lies a turn beside it
//! (`Space::beside`). Folds, flips and Neimark–Sacker points (products of multipliers equal to one) are zeros of test functions along the branch;
//! they are computed to the last digits, and again with another tolerance, and the difference is the error (`special.rs`). A test function that is noise, such as a determinant of a conservative system, has no sign. Secondary branches
//! are followed in the larger space until they return to a smaller one, and those of eight or more periods until deviations grow a thousandfold
//! in one; the branch on which another branch ends is followed too (`response.rs`).
//!
//! A point is accepted if the motion, integrated over its whole period by the equation alone, returns within the grown
//! error of its start (`description.rs`). If deviations grow more than 5e9-fold, so that rounding errors exceed 1e-6,
//! it is accepted if multiple shooting with the whole equation ends within the errors of the motion (`pieces.rs`).

mod error;
mod drive_law;
mod field;
mod mirror;
mod space;
mod turns;
mod units;
mod centre;
mod symmetry;
mod family;
mod corrector;
mod description;
mod pieces;
mod point;
mod node;
mod special;
mod hopf;
mod backbone;
mod branch;
mod established;
mod restarts;
mod undriven;
mod jumps;
mod landings;
mod order;
mod options;
mod search;
mod coordinate_units;
mod switching;
mod rotations;
mod further_starts;
mod harmonic_balance;
mod energy_balance;
mod full_strength;
mod orders;
mod response;
mod sweep;
mod curve;
mod edges;
mod singular;
mod chart;
mod precise_flow;
mod precise;

pub use backbone::FreeOscillation;
pub use branch::{Branch, Ending, Origin};
pub use chart::{ChartOptions, StabilityChart};
pub use curve::{BoundaryPart, CurvePoint, SpecialCurve};
pub use edges::RestStability;
pub use error::BranchError;
pub use jumps::Jump;
pub use options::ResponseOptions;
pub use order::{ParseOrderError, ResonanceOrder};
pub use orders::{OrderAnswers, OrderFinding};
pub use point::BranchPoint;
pub use precise::PreciseSpecial;
pub use response::Response;
pub use space::{Rotation, Space};
pub use special::{SpecialKind, SpecialPoint};
pub use sweep::{Sweep, SweepPoint};
