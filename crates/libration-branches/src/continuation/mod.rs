//! Branches of periodic motions of driven and self-excited systems over a parameter, through their folds, with stability and errors.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::continuation::{Response, ResponseOptions, SpecialKind};
//!
//! let pendulum = "theta'' = -0.1*theta' - sin(theta) + 0.15*cos(w*t)".parse()?;
//! let response = Response::over(&pendulum, "w", [0.3, 1.4], &ResponseOptions::default())?;
//! let folds: Vec<f64> = response.branches[0]
//!     .special
//!     .iter()
//!     .filter(|special| special.kind == SpecialKind::Fold)
//!     .map(|special| special.point.parameter)
//!     .collect();
//! // The jump up, going down: by Fourier collocation 0.8721575691379171688795389.
//! assert!((folds[0] - 0.87215756913791717).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;

mod drive_law;
mod field;
mod space;
mod units;

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

mod jumps;

mod order;

mod options;

mod search;
mod switching;

mod rotations;

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

pub use backbone::free_oscillations;
pub use branch::{Branch, Ending, Origin};
pub use chart::{ChartOptions, StabilityChart};
pub use curve::{CurvePoint, SpecialCurve};
pub use edges::RestStability;
pub use error::NoBranch;
pub use jumps::Jump;
pub use options::ResponseOptions;
pub use order::{NoOrder, ResonanceOrder};
pub use orders::{OrderAnswers, OrderFinding};
pub use point::BranchPoint;
pub use precise::PreciseSpecial;
pub use response::Response;
pub use space::{Rotation, Space};
pub use special::{SpecialKind, SpecialPoint};
pub use sweep::{Sweep, SweepPoint};
