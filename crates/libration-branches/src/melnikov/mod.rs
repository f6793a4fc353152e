//! A pendulum under a weak periodic perturbation: Melnikov's function of the separatrix, resonances of the swings and rotations, their overlap.
//!
//! ```
//! # extern crate libration_branches as libration;
//! use libration::melnikov::{Melnikov, PerturbedPendulum};
//! use libration::progress::Quiet;
//! let shaken = PerturbedPendulum::new(&"x'' + 0.1 x' + (1 - 0.2 cos(2t)) sin(x) = 0".parse()?)?;
//! let [upper, lower] = Melnikov::both(&shaken, &Quiet)?;
//! assert_eq!(upper.has_simple_zeros(), Some(false));
//! assert_eq!(upper.mean, lower.mean);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! The acceleration becomes a polynomial in θ′, sin θ, cos θ and e^{iΩt} (`trigonometric.rs`); the term −ω0²·sin θ is the pendulum, with θ
//! counted from where it hangs (a·sin x + b·cos x alone are one sine), the others are the perturbation. On the separatrix each term is sechⁿ, or
//! sechⁿ·tanh, times a wave, whose integral is a residue at t = iπ/2 in closed form (`separatrix.rs`), with all digits however fast the drive
//! and small the value. Terms of another form are integrated by the trapezoidal rule. For resonances, the mean power of the same perturbation is
//! taken over the exact motions with frequency pΩ/q.

mod error;
mod trigonometric;
pub(crate) mod perturbation;

#[doc(hidden)]
pub(crate) mod separatrix;
mod function;
mod resonance;
mod saddle;
mod manifolds;
mod tangency;

pub use error::{MelnikovError, TangencyError};
pub use function::{Melnikov, Threshold, thresholds};
pub use perturbation::PerturbedPendulum;
pub use resonance::DriveResonance;
pub use tangency::Tangency;
