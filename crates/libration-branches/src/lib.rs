//! Dependence of motions on a parameter or on the amplitude: branches of periodic motions, normal modes and their continuation, normal forms of
//! coupled modes, Melnikov's method. The crate `libration` re-exports the modules.

pub mod continuation;
pub mod melnikov;
pub mod nonlinear_modes;
pub mod normal_form;
pub mod normal_modes;

// The modules of lower crates under the names that `libration` gives them, so that examples read as in users' code.
#[doc(hidden)]
pub use libration_kernels::elliptic;
#[doc(hidden)]
pub use libration_motion::{chaos, decay, orbit, oscillator, spectrum, systems, taylor};
#[doc(hidden)]
pub use libration_numbers::{algebra, catalogue, expression, progress, quadrature, quantity, roots, series};
#[doc(hidden)]
pub use libration_pendulum::{pendulum, period_formulas};

/// Internals that the other crates of this workspace and the tests use. They may change at any time.
#[doc(hidden)]
pub mod internals {
    pub mod melnikov {
        pub use crate::melnikov::{perturbation::power, separatrix::sech_power};
    }
    pub mod normal_modes {
        pub use crate::normal_modes::roots::{Root, roots};
    }
}
