//! Perturbation series compared with exact values computed without them: elliptic functions for the pendulum,
//! the integrated equation of motion for other oscillators.
//!
//! ```
//! # extern crate libration_perturbation as libration;
//! use libration::comparison::Backbone;
//! use libration::elliptic::Modulus;
//! use libration::progress::Quiet;
//!
//! // A spring that stiffens: how its frequency rises with the amplitude, by integration and by its series.
//! let backbone = Backbone::new(&"x'' + x + x^3 = 0".parse()?, None, 15, &Quiet)?;
//! let point = backbone.at(0.5, &Quiet);
//! let (orbit, series) = (point.orbit?, point.series.ok_or("no series")?);
//! // In closed form it is π√(1 + A²)/2K(m) with m = A²/(2 + 2A²), here 1/10.
//! let exact = std::f64::consts::FRAC_PI_2 * 1.25_f64.sqrt() / Modulus::from_parameter(0.1)?.first();
//! assert!((orbit.frequency - exact).abs() <= 1e-14);
//! assert!((series.frequency - exact).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod approximant;
mod quantity;

#[doc(hidden)]
pub(crate) mod enclosed;
mod exact;
mod pendulum_harmonic;
mod relation;
mod backbone;
mod cycle_distance;
mod leading_cycles;
mod scaling_law;
mod slow_decay;
#[doc(hidden)]
pub(crate) mod work;

pub use approximant::Approximant;
pub use backbone::{Backbone, BackboneError, BackbonePoint, OrbitFrequency, SeriesError, SeriesFrequency};
pub use cycle_distance::CycleDistance;
pub use exact::{ExactMotion, ExactValue, ExactValueError, Method};
pub use leading_cycles::{LeadingLimitCycle, LeadingLimitCycles, LeadingLimitCyclesError};
pub use quantity::{ParseSeriesQuantityError, SeriesQuantity};
pub use relation::{Radius, SeriesComparison};
pub use scaling_law::{HarmonicRatio, ScalingLaw};
pub use slow_decay::{SlowDecay, SlowDecayError, SlowState};
