//! Motion in time of any equations: Taylor integration with events, named systems, oscillators about an equilibrium, periodic orbits, decay
//! under damping, chaos, spectra. The crate `libration` re-exports its modules.

pub mod chaos;
pub mod decay;
pub mod orbit;
pub mod oscillator;
pub mod spectrum;
pub mod systems;
pub mod taylor;

// The modules of the crates below under the names that `libration` gives them, so that examples read as its users write them.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, quadrature, quantity, roots, series, watch};
#[doc(hidden)]
pub use libration_pendulum::{pendulum, period_formulas};

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod orbit {
        pub use crate::orbit::{place::ReleasePlace, released::depends_on_time};
    }
}
