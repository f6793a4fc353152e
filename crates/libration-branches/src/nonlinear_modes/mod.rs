//! Nonlinear normal modes: modes of small oscillations continued to large amplitudes, as periodic orbits with their stability.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::nonlinear_modes::NonlinearMode;
//! use libration::normal_modes::NormalModes;
//! use libration::progress::Quiet;
//! // Two equal pendulums, coupled: in phase each swings like a single one.
//! let equation = "x'' = -sin(x) + (y - x)/5; y'' = -sin(y) + (x - y)/5".parse()?;
//! let modes = NormalModes::new(&equation)?;
//! let together = NonlinearMode::follow(&equation, &modes, 0, 0, &[0.5, 1.0], &Quiet)?;
//! let point = &together.points[1];
//! let alone = libration::pendulum::Pendulum::from_angular_frequency(1.0)?.released_from("1".parse()?)?;
//! assert!((point.orbit.period() - alone.period()).abs() < 1e-12 && (point.start[1] - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod belonging;
mod mode;

pub use error::{LostMode, NonlinearModeError, Reason};
pub use mode::{ModePoint, NonlinearMode, StabilityChange};
